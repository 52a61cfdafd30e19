// Where the events come from: a server (live run or run folder), or the page itself (report.html).
// Both give: onEvents(list), onClose(), picture([begin, bytes]) -> address of an image, text(name), send(order).

export function openSource() {
  const embedded = document.getElementById('run');
  return embedded ? new EmbeddedSource(JSON.parse(embedded.textContent)) : new ServerSource();
}

class EmbeddedSource {
  constructor(run) { this.run = run; }
  get still() { return true; }
  start(onEvents) { onEvents(this.run.events); }
  async picture([begin]) { return this.run.pictures[begin]; }
  async text(name) { return this.run.texts[name]; }
  send() {}
}

const MOST_PICTURES = 80;

class ServerSource {
  constructor() { this.pictures = new Map(); }
  get still() { return false; }

  start(onEvents, onClose) {
    this.socket = new WebSocket(`ws://${location.host}/events`);
    this.socket.onmessage = (message) => {
      onEvents(message.data.split('\n').filter((line) => line).map((line) => JSON.parse(line)));
    };
    this.socket.onclose = onClose;
  }

  /** Slices of camera.bin, the newest ones kept. */
  picture([begin, bytes]) {
    let address = this.pictures.get(begin);
    if (!address) {
      address = this.fetchPicture(begin, bytes);
      this.pictures.set(begin, address);
      address.then((url) => url || this.pictures.delete(begin)); // asked for again when it is wanted again
      if (this.pictures.size > MOST_PICTURES) {
        const [oldest, old] = this.pictures.entries().next().value;
        this.pictures.delete(oldest);
        old.then((url) => url && URL.revokeObjectURL(url));
      }
    }
    return address;
  }
  async fetchPicture(begin, bytes) {
    try {
      const answer = await fetch('/camera.bin', { headers: { Range: `bytes=${begin}-${begin + bytes - 1}` } });
      if (answer.status !== 206) return undefined;
      return URL.createObjectURL(new Blob([await answer.arrayBuffer()], { type: 'image/jpeg' }));
    } catch {
      return undefined; // the server has gone
    }
  }
  async text(name) {
    try {
      const answer = await fetch('/' + name);
      return answer.ok ? await answer.text() : undefined;
    } catch {
      return undefined;
    }
  }
  send(order) {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(order));
  }
}
