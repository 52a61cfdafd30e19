#!/usr/bin/env python3
"""What it costs a tidy-up run to be watched or recorded, in processor time and wall time, and whether its digest stays.

    tests/bench/watching_cost.py [--amiss build/release/apps/amiss/amiss] [--rounds 5] [--ways page,deaf,mcap,rawlog]
        [-- further arguments of tidy]

Each round does the run alone and once each way, one after the other, as fast as possible; what is printed are ratios to
the same round's run alone, so that what else the machine does falls out. The ways:
    page     --view, and a client that takes what the page takes: all events, both pictures of the newest frame, five times
             a second
    deaf     --view, and a client that connects and never reads
    mcap, rawlog, both     --record
Wall time is the run's own (report.json), processor time is user and system of its process; the client is not in it.
"""
import argparse
import http.client
import json
import os
import pathlib
import re
import socket
import statistics
import struct
import subprocess
import sys
import tempfile
import threading
import time

PICTURES_EVERY = 0.2  # s, as share/web/src/main.js updates what is no event
FRAME = re.compile(rb'^\{"e":"frame".*"colour":\[(\d+),(\d+)\],"depth":\[(\d+),(\d+)\]')


class Page(threading.Thread):
    """A client of the run's page, until close()."""

    def __init__(self, port, reads):
        super().__init__(daemon=True)
        self.port, self.reads, self.events, self.bytes, self.pictures = port, reads, 0, 0, 0
        self.socket = socket.create_connection(("127.0.0.1", port))
        self.socket.sendall((f"GET /events HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\n"
                             "Connection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                             "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n").encode())
        self.stream = self.socket.makefile("rb", 1 << 16)
        if b"101" not in self.stream.readline():
            raise RuntimeError("the run refused the page")
        while self.stream.readline() != b"\r\n":
            pass
        self.start()

    def run(self):
        pictures, due = http.client.HTTPConnection("127.0.0.1", self.port), 0.0
        try:
            while self.reads:
                lines = self.message().splitlines()
                self.events += len(lines)
                newest = next(filter(None, map(FRAME.match, reversed(lines))), None)
                if not newest or time.monotonic() < due:
                    continue
                due = time.monotonic() + PICTURES_EVERY
                begin, size, depth_begin, depth_size = map(int, newest.groups())
                for first, count in ((begin, size), (depth_begin, depth_size)):
                    pictures.request("GET", "/camera.bin", headers={"Range": f"bytes={first}-{first + count - 1}"})
                    self.pictures += len(pictures.getresponse().read()) == count
        except (OSError, EOFError, http.client.HTTPException):
            pass

    def message(self):
        """One WebSocket message, of any number of fragments."""
        whole = b""
        while True:
            first, second = self.take(2)
            length = second & 127
            if length > 125:
                length, = struct.unpack(">H" if length == 126 else ">Q", self.take(2 if length == 126 else 8))
            part = self.take(length)
            self.bytes += length
            whole += part if first & 15 <= 2 else b""
            if first & 128:
                return whole

    def take(self, count):
        data = self.stream.read(count)
        if len(data) < count:
            raise EOFError
        return data

    def close(self):
        self.socket.shutdown(socket.SHUT_RDWR)
        self.join()
        self.socket.close()


def run(args, way, folder):
    words = [args.amiss, "tidy", "--out", str(folder), "--quiet", *args.further]
    if way in ("page", "deaf"):
        words += ["--view", "--port", "0"]
    elif way != "alone":
        words += ["--record", way]
    child = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    page, said = None, ""
    if way in ("page", "deaf"):
        for said in child.stderr:
            if address := re.search(r"watch at http://127\.0\.0\.1:(\d+)/", said):
                page = Page(int(address[1]), way == "page")
                while not (folder / "report.json").exists() and not os.waitid(
                        os.P_PID, child.pid, os.WEXITED | os.WNOHANG | os.WNOWAIT):
                    time.sleep(0.05)
                break
    if page:
        page.close()
    said += child.stderr.read()
    _, status, usage = os.wait4(child.pid, 0)
    if not (folder / "report.json").exists():
        raise SystemExit(f"{' '.join(words)}: status {os.waitstatus_to_exitcode(status)}: {said.strip()}")
    report = json.loads((folder / "report.json").read_text())
    recorded = sum(f.stat().st_size for f in folder.glob("recording.*")) / report["time"]["simulated_s"] / 1e6
    notes = f"{recorded:.2f} MB a simulated second" if recorded else ""
    if way == "page":
        notes = f"{page.events} events, {page.bytes / 1e6:.1f} MB, {page.pictures} pictures"
    return {"wall": report["time"]["wall_s"], "cpu": usage.ru_utime + usage.ru_stime,
            "peak": usage.ru_maxrss / 1024, "digest": report["digest"], "notes": notes}


def spread(values):
    return f"{statistics.median(values):5.3f} ({min(values):5.3f} to {max(values):5.3f})"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--amiss", default="build/release/apps/amiss/amiss")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--ways", type=lambda text: text.split(","), default=["page", "deaf", "mcap", "rawlog"])
    parser.add_argument("further", nargs="*")
    args = parser.parse_args()
    results = {way: [] for way in ["alone", *args.ways]}
    with tempfile.TemporaryDirectory() as folder:
        run(args, "alone", pathlib.Path(folder) / "warm")  # makes the reference map where it is not kept yet
        for round_ in range(args.rounds):
            for way in results:
                results[way].append(run(args, way, pathlib.Path(folder) / way))
                subprocess.run(["rm", "-rf", pathlib.Path(folder) / way], check=True)
                print(f"{round_ + 1}/{args.rounds} {way}: wall {results[way][-1]['wall']:.2f} s,"
                      f" processor {results[way][-1]['cpu']:.2f} s", file=sys.stderr)
    alone = results.pop("alone")
    digests = {r["digest"] for r in alone}
    print(f"alone: {statistics.median(r['wall'] for r in alone):.2f} s of wall time,"
          f" {statistics.median(r['cpu'] for r in alone):.2f} s of processor time; ratios are median (least to most)")
    for way, runs in results.items():
        same = digests | {r["digest"] for r in runs}
        print(f"{way:<7} wall {spread([r['wall'] / a['wall'] for r, a in zip(runs, alone)])}"
              f"   processor {spread([r['cpu'] / a['cpu'] for r, a in zip(runs, alone)])}"
              f"   memory {statistics.median(r['peak'] - a['peak'] for r, a in zip(runs, alone)):+.0f} MB"
              f"   digest {'the same' if len(same) == 1 else 'DIFFERS'}   {runs[-1]['notes']}")
        digests = same if len(same) == 1 else digests
        if len(same) > 1:
            args.differs = True
    return 1 if getattr(args, "differs", False) else 0


if __name__ == "__main__":
    sys.exit(main())
