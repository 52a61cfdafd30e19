// A recording in the readers of others: @mcap/core with all CRCs, @foxglove/rosmsg2-serialization for every message.
// usage: node mcap_test.mjs PROGRAM WORLD FOLDER
// Ends with 77 where these packages are not there (`npm ci` in tests/web).
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';

const [program, world, folder] = process.argv.slice(2);
const require = createRequire(import.meta.url);
let mcap, support, crc, rosmsg, serialization;
try {
  [mcap, support, crc, rosmsg, serialization] = ['@mcap/core', '@mcap/support', '@foxglove/crc', '@foxglove/rosmsg',
    '@foxglove/rosmsg2-serialization'].map(require);
} catch {
  console.log('the packages of tests/web are not there: skipped');
  process.exit(77);
}

rmSync(join(folder, 'recorded'), { recursive: true, force: true });
mkdirSync(folder, { recursive: true });
execFileSync(resolve(program), ['tidy', '--world', world, '--objects', '1', '--seed', '3', '--record', 'mcap', '--out',
  'recorded', '--quiet'], { cwd: folder, stdio: 'inherit' });
const report = JSON.parse(readFileSync(join(folder, 'recorded', 'report.json'), 'utf8'));
const bytes = readFileSync(join(folder, 'recorded', 'recording.mcap'));
const decompressHandlers = await support.loadDecompressHandlers();

/** Every message by its topic, decoded by its own schema; each has to be used up to its last byte. */
class Decoder {
  readers = new Map();
  byTopic = new Map();
  add(schema, channel, message) {
    if (!this.readers.has(channel.id)) {
      assert.equal(schema.encoding, 'ros2msg');
      assert.equal(channel.messageEncoding, 'cdr');
      const definition = rosmsg.parse(new TextDecoder().decode(schema.data), { ros2: true });
      this.readers.set(channel.id, new serialization.MessageReader(definition));
      this.byTopic.set(channel.topic, []);
    }
    const value = this.readers.get(channel.id).readMessage(message.data);
    this.byTopic.get(channel.topic).push(value);
  }
}

// From front to back: every record, every chunk's CRC.
const stream = new mcap.McapStreamReader({ decompressHandlers, validateCrcs: true });
stream.append(bytes);
const schemas = new Map(), channels = new Map(), decoder = new Decoder();
const attachments = new Map();
let messages = 0, dataEnd, footer, header;
for (let record; (record = stream.nextRecord()); ) {
  if (record.type === 'Header') header = record;
  if (record.type === 'Schema') schemas.set(record.id, record);
  if (record.type === 'Channel') channels.set(record.id, record);
  if (record.type === 'Attachment') attachments.set(record.name, record.data);
  if (record.type === 'DataEnd') dataEnd = record;
  if (record.type === 'Footer') footer = record;
  if (record.type !== 'Message') continue;
  const channel = channels.get(record.channelId);
  decoder.add(schemas.get(channel.schemaId), channel, record);
  ++messages;
}
assert.ok(stream.done());
assert.equal(header.profile, 'ros2');

// CRC of the data and of the summary, over the bytes that the specification names.
const footerAt = bytes.length - 8 - 20 - 9, summaryAt = Number(footer.summaryStart), dataEndAt = summaryAt - 4 - 9;
assert.equal(crc.crc32(bytes.subarray(0, dataEndAt)), dataEnd.dataSectionCrc);
assert.equal(crc.crc32(bytes.subarray(summaryAt, footerAt + 9 + 16)), footer.summaryCrc);

// By its indexes: the same messages, in the order of time.
const readable = {
  size: async () => BigInt(bytes.length),
  read: async (offset, size) => bytes.subarray(Number(offset), Number(offset + size)),
};
const indexed = await mcap.McapIndexedReader.Initialize({ readable, decompressHandlers });
assert.equal(Number(indexed.statistics.messageCount), messages);
assert.equal(indexed.statistics.chunkCount, indexed.chunkIndexes.length);
let last = 0n, seen = 0;
for await (const message of indexed.readMessages({ validateCrcs: true })) {
  assert.ok(message.logTime >= last);
  last = message.logTime;
  ++seen;
}
assert.equal(seen, messages);
let attached = 0;
for await (const attachment of indexed.readAttachments({ validateCrcs: true })) {
  assert.deepEqual(Buffer.from(attachment.data), Buffer.from(attachments.get(attachment.name)));
  ++attached;
}
assert.equal(attached, attachments.size);
for (const name of ['params.yaml', 'world.sdf', 'map.yaml', 'map.pgm', 'mapped.ot', 'reference.ot']) {
  assert.ok(attachments.has(name), name);
}
const seconds = Math.floor(report.time.simulated_s);
assert.ok(indexed.chunkIndexes.length >= 2 * seconds, 'a chunk for each half of a simulated second');

// What the messages say.
const of = (topic) => {
  assert.ok(decoder.byTopic.has(topic), `${topic} is missing`);
  return decoder.byTopic.get(topic);
};
const children = new Set(of('/tf').concat(of('/tf_static')).flatMap((m) => m.transforms.map((t) => t.child_frame_id)));
assert.deepEqual([...children].sort(), ['base_link', 'camera', 'laser', 'odom']);
for (const { rotation: q } of of('/tf').flatMap((m) => m.transforms.map((t) => t.transform))) {
  assert.ok(Math.abs(Math.hypot(q.x, q.y, q.z, q.w) - 1) < 1e-9);
}
const depth = of('/camera/depth/image_raw'), info = of('/camera/camera_info');
assert.equal(depth.length, info.length);
assert.equal(of('/camera/rgb/image_raw/compressed').length, depth.length);
for (const picture of of('/camera/rgb/image_raw/compressed')) assert.deepEqual([...picture.data.subarray(0, 2)], [0xff, 0xd8]);
for (const image of depth) assert.equal(image.data.length, image.step * image.height);
const metres = new Float32Array(depth[0].data.slice().buffer);
assert.ok(metres.every((m) => Number.isNaN(m) || (m > 0.3 && m < 9)));
assert.ok(metres.filter((m) => m > 0).length > metres.length / 4);
assert.ok(info[0].k[0] > 300 && info[0].width === depth[0].width);
const scan = of('/scan')[0];
assert.ok(scan.ranges.length > 100 && Math.abs(scan.angle_min + scan.angle_increment * (scan.ranges.length - 1) - scan.angle_max) < 1e-3);
const map = of('/map')[0];
assert.equal(map.data.length, map.info.width * map.info.height);
assert.ok(map.data.includes(100) && map.data.includes(0) && map.data.includes(-1));
const cloud = of('/voxels').at(-1);
assert.equal(cloud.data.length, cloud.width * cloud.point_step);
assert.ok(cloud.width > 500);
const markers = of('/regions').at(-1).markers;
assert.equal(markers.filter((m) => m.ns === 'regions').length, report.regions.detected - report.regions.withdrawn);
assert.ok(markers.some((m) => m.ns === 'objects'));
assert.ok(of('/plan')[0].data.includes('goto_waypoint'));
const said = readFileSync(join(folder, 'recorded', 'log.txt'), 'utf8').trim().split('\n').map((line) => line.replace(/^.* s {2}/, ''));
assert.deepEqual(of('/rosout').map((m) => m.msg), said, 'the run\'s log');
assert.ok(of('/path')[0].poses.length > 1);
assert.equal(of('/odom').length, of('/amiss/observation').length);
console.log(`${messages} messages on ${decoder.byTopic.size} topics, ${indexed.chunkIndexes.length} chunks, ` +
  `${attached} attachments, ${(bytes.length / 1e6).toFixed(1)} MB for ${report.time.simulated_s.toFixed(1)} s`);
