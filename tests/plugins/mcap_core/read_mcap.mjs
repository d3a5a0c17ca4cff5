// Reads an MCAP file with both readers of @mcap/core and prints its topics: npm install @mcap/core; then
// node read_mcap.mjs FILE. Ends with an error where a checksum, an index or a count of the file is wrong.
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";

const bytes = readFileSync(process.argv[2]);
const readable = {
  size: async () => BigInt(bytes.length),
  read: async (offset, size) => new Uint8Array(bytes.subarray(Number(offset), Number(offset + size))),
};
const reader = await McapIndexedReader.Initialize({ readable });
const counts = new Map();
for await (const message of reader.readMessages({ validateCrcs: true })) {
  JSON.parse(new TextDecoder().decode(message.data));
  counts.set(message.channelId, (counts.get(message.channelId) ?? 0n) + 1n);
}
assert.deepEqual(counts, reader.statistics.channelMessageCounts);

const stream = new McapStreamReader({ validateCrcs: true });
stream.append(bytes);
let messages = 0n;
for (let record; (record = stream.nextRecord()); ) messages += record.type === "Message" ? 1n : 0n;
assert.ok(stream.done());
assert.equal(messages, reader.statistics.messageCount);

for (const { id, topic, schemaId, metadata } of reader.channelsById.values()) {
  const schema = JSON.parse(new TextDecoder().decode(reader.schemasById.get(schemaId).data));
  console.log(topic, counts.get(id) ?? 0n, JSON.stringify(schema.properties), Object.fromEntries(metadata));
}
