// Reads an MCAP file with both readers of @mcap/core: npm ci; then node read_mcap.mjs FILE prints its topics. Ends with an
// error where a checksum, an index or a count of the file is wrong.
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

/** Topics of a file by name: their messages (JSON) in the order of time, the properties of their schema, and metadata. */
export async function readMcap(file) {
  const bytes = readFileSync(file);
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, size) => new Uint8Array(bytes.subarray(Number(offset), Number(offset + size))),
  };
  const reader = await McapIndexedReader.Initialize({ readable });
  const topics = new Map();
  for (const { topic, schemaId, metadata } of reader.channelsById.values()) {
    const schema = JSON.parse(new TextDecoder().decode(reader.schemasById.get(schemaId).data));
    topics.set(topic, { messages: [], properties: schema.properties, metadata: Object.fromEntries(metadata) });
  }
  const counts = new Map();
  for await (const message of reader.readMessages({ validateCrcs: true })) {
    topics.get(reader.channelsById.get(message.channelId).topic).messages.push(JSON.parse(new TextDecoder().decode(message.data)));
    counts.set(message.channelId, (counts.get(message.channelId) ?? 0n) + 1n);
  }
  assert.deepEqual(counts, reader.statistics.channelMessageCounts);

  const stream = new McapStreamReader({ validateCrcs: true });
  stream.append(bytes);
  let messages = 0n;
  for (let record; (record = stream.nextRecord()); ) messages += record.type === "Message" ? 1n : 0n;
  assert.ok(stream.done());
  assert.equal(messages, reader.statistics.messageCount);
  return topics;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href)
  for (const [topic, { messages, properties, metadata }] of await readMcap(process.argv[2]))
    console.log(topic, messages.length, JSON.stringify(properties), metadata);
