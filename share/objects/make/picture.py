"""Small pictures for labels: rectangles, discs, stripes and capital letters; written as PNG."""
import struct
import zlib

_ROWS = {  # 5 x 7 dots, one hexadecimal pair a row
    "A": "0E11111F111111", "B": "1E11111E11111E", "C": "0E11101010110E", "D": "1E11111111111E", "E": "1F10101E10101F",
    "F": "1F10101E101010", "G": "0E11101713110F", "H": "1111111F111111", "I": "0E04040404040E", "J": "0702020202120C",
    "K": "11121418141211", "L": "1010101010101F", "M": "111B1515111111", "N": "11191513111111", "O": "0E11111111110E",
    "P": "1E11111E101010", "Q": "0E11111115120D", "R": "1E11111E141211", "S": "0F10100E01011E", "T": "1F040404040404",
    "U": "1111111111110E", "V": "11111111110A04", "W": "11111115151B11", "X": "11110A040A1111", "Y": "11110A04040404",
    "Z": "1F01020408101F", "1": "040C040404040E", "2": "0E11010204081F", "3": "1F02040201110E", "0": "0E11131519110E",
    " ": "00000000000000",
}


class Picture:
    """Row 0 on top; colours are (r, g, b), 0 .. 255."""

    def __init__(self, width, height, colour):
        self.width, self.height = width, height
        self.rows = [[tuple(colour)] * width for _ in range(height)]

    def rectangle(self, x0, y0, x1, y1, colour):
        for y in range(max(0, y0), min(self.height, y1)):
            for x in range(max(0, x0), min(self.width, x1)):
                self.rows[y][x] = tuple(colour)
        return self

    def disc(self, cx, cy, rx, ry, colour):
        for y in range(max(0, cy - ry), min(self.height, cy + ry + 1)):
            for x in range(max(0, cx - rx), min(self.width, cx + rx + 1)):
                if ((x - cx) / rx) ** 2 + ((y - cy) / ry) ** 2 <= 1.0:
                    self.rows[y][x] = tuple(colour)
        return self

    def text(self, words, cx, cy, dot, colour):
        """Centred at (cx, cy), a dot of the letters is `dot` pixels wide."""
        x, y = cx - 3 * dot * len(words), cy - 7 * dot // 2
        for letter in words:
            for row in range(7):
                bits = int(_ROWS[letter][2 * row:2 * row + 2], 16)
                for column in range(5):
                    if bits >> (4 - column) & 1:
                        px, py = x + column * dot, y + row * dot
                        self.rectangle(px, py, px + dot, py + dot, colour)
            x += 6 * dot
        return self

    def lines(self, x0, y0, x1, count, pitch, colour):
        """Small print: thin lines of uneven length."""
        for i in range(count):
            self.rectangle(x0, y0 + i * pitch, x1 - (i * 37 % 29) * (x1 - x0) // 80, y0 + i * pitch + max(1, pitch // 3),
                           colour)
        return self

    def grain(self, amount, seed=1):
        """A little unevenness that is the same in every run."""
        state = seed
        for row in self.rows:
            for x, colour in enumerate(row):
                state = (1103515245 * state + 12345) % 2 ** 31
                shift = (state >> 16) % (2 * amount + 1) - amount
                row[x] = tuple(min(255, max(0, c + shift)) for c in colour)
        return self

    def png(self):
        def chunk(kind, data):
            return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        raw = b"".join(b"\0" + bytes(v for colour in row for v in colour) for row in self.rows)
        head = struct.pack(">IIBBBBB", self.width, self.height, 8, 2, 0, 0, 0)
        return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b"")
