// Where the events come from: a server (live run or run folder), or the page itself (report.html).
// Both give: picture([begin, bytes]) -> address of an image, text(name), send(order); and tell what comes by
// told.begin() (all events from the first one on follow), told.add(list), told.lost(attempt, of), told.over(why).

export function openSource() {
  const embedded = document.getElementById('run');
  return embedded ? new EmbeddedSource(JSON.parse(embedded.textContent)) : new ServerSource();
}

class EmbeddedSource {
  constructor(run) { this.run = run; }
  get still() { return true; }
  start(told) {
    told.begin();
    told.add(this.run.events);
  }
  async picture([begin]) { return this.run.pictures[begin]; }
  async text(name) { return this.run.texts[name]; }
  send() {}
}

const MOST_PICTURES = 80;
/** How long to wait [ms] before each attempt to connect again; then the run is given up. */
const PAUSES = [250, 500, 1000, 2000, 4000];

class ServerSource {
  constructor() {
    this.pictures = new Map();
    this.attempts = 0; // since something was heard
    this.complete = false; // the end of the run was heard
  }
  get still() { return false; }

  start(told) {
    this.told = told;
    this.connect();
  }

  connect() {
    let heard = false;
    this.socket = new WebSocket(`ws://${location.host}/events`);
    this.socket.onmessage = (message) => {
      if (!heard) this.told.begin(); // the server tells all events again to each connection
      heard = true;
      this.attempts = 0;
      const events = message.data.split('\n').filter((line) => line).map((line) => JSON.parse(line));
      this.complete ||= events.some((event) => event.e === 'end');
      this.told.add(events);
    };
    this.socket.onclose = () => this.connectAgain();
  }

  async connectAgain() {
    if (this.complete) return this.told.over('gone'); // nothing more would come
    if (this.attempts < PAUSES.length) {
      setTimeout(() => this.connect(), PAUSES[this.attempts++]);
      return this.told.lost(this.attempts, PAUSES.length);
    }
    const answers = await fetch('/', { method: 'HEAD' }).then(() => true, () => false);
    this.told.over(answers ? 'refused' : 'gone');
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
