// Writes the bags of this folder: npm install @mcap/core @foxglove/rosmsg @foxglove/rosmsg2-serialization; then
// node make_bags.mjs, with the programs lz4, zstd and sqlite3. A pendulum swings for 2 s under a torque; joint states come
// every 10 ms, commands every 20 ms, recorded 2 ms after their stamps.
import { McapWriter } from "@mcap/core";
import { parse } from "@foxglove/rosmsg";
import { MessageWriter } from "@foxglove/rosmsg2-serialization";
import { spawnSync } from "node:child_process";
import { rmSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const rule = "=".repeat(80);
const jointState = `# State of joints.
std_msgs/Header header
string[] name
float64[] position
float64[] velocity
float64[] effort
${rule}
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
${rule}
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
`;
const multiArray = `std_msgs/MultiArrayLayout layout
float64[] data
${rule}
MSG: std_msgs/MultiArrayLayout
MultiArrayDimension[] dim
uint32 data_offset
${rule}
MSG: std_msgs/MultiArrayDimension
string label
uint32 size
uint32 stride
`;
const topics = [
  { name: "/joint_states", type: "sensor_msgs/msg/JointState", definition: jointState },
  { name: "/effort_controller/commands", type: "std_msgs/msg/Float64MultiArray", definition: multiArray },
  { name: "/robot_description", type: "std_msgs/msg/String", definition: "string data" },
].map((topic) => ({ ...topic, writer: new MessageWriter(parse(topic.definition, { ros2: true })) }));

const start = 1700000000n * 1000000000n;
const at = (ns) => ({ sec: Number(ns / 1000000000n), nanosec: Number(ns % 1000000000n) });

function messages() {
  const all = [];
  const add = (topic, ns, content) => all.push({ topic, ns, bytes: topics[topic].writer.writeMessage(content) });
  add(2, start, { data: '<robot name="arm"/>' });
  let angle = 0.1;
  let rate = 0;
  for (let i = 0; i < 200; ++i) {
    const time = start + BigInt(i) * 10000000n;
    const torque = 0.5 * Math.sin(0.03 * i) + 0.2 * Math.sin(0.11 * i);
    if (i % 2 === 0) add(1, time + 1000000n, { layout: { dim: [], data_offset: 0 }, data: [torque] });
    add(0, time + 2000000n, {
      header: { stamp: at(time), frame_id: "" },
      name: ["elbow", "hinge"], position: [0, angle], velocity: [0, rate], effort: [0, torque],
    });
    for (let k = 0; k < 10; ++k) {
      rate += 0.001 * ((torque - 9.81 * 0.2 * Math.sin(angle) - 0.05 * rate) / 0.05);
      angle += 0.001 * rate;
    }
  }
  return all;
}

function packed(program, args) {
  return (data) => ({ compression: program, compressedData: spawnSync(program, args, { input: data }).stdout });
}

async function writeMcap(file, options) {
  const pieces = [];
  let size = 0n;
  const writable = {
    position: () => size,
    write: async (bytes) => { pieces.push(Buffer.from(bytes)); size += BigInt(bytes.length); },
  };
  const writer = new McapWriter({ writable, ...options });
  await writer.start({ profile: "ros2", library: "" });
  const ids = [];
  for (const topic of topics) {
    const schemaId = await writer.registerSchema({
      name: topic.type, encoding: "ros2msg", data: new TextEncoder().encode(topic.definition),
    });
    ids.push(await writer.registerChannel({ schemaId, topic: topic.name, messageEncoding: "cdr", metadata: new Map() }));
  }
  let sequence = 0;
  for (const { topic, ns, bytes } of messages())
    await writer.addMessage({ channelId: ids[topic], sequence: sequence++, logTime: ns, publishTime: ns, data: bytes });
  await writer.end();
  writeFileSync(join(here, file), Buffer.concat(pieces));
}

/// As rosbag2 writes it; of Iron and later with the definitions.
function writeSqlite(file, withDefinitions) {
  const lines = [
    "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, " +
      "serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);",
    "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL, data BLOB NOT NULL);",
    "CREATE INDEX timestamp_idx ON messages (timestamp ASC);",
  ];
  topics.forEach(({ name, type }, i) => lines.push(`INSERT INTO topics VALUES(${i + 1}, '${name}', '${type}', 'cdr', '');`));
  messages().filter(({ ns }) => ns < start + 400000000n).forEach(({ topic, ns, bytes }) =>
    lines.push(`INSERT INTO messages(topic_id, timestamp, data) VALUES(${topic + 1}, ${ns}, X'${Buffer.from(bytes).toString("hex")}');`));
  if (withDefinitions) {
    lines.push("CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL, encoding TEXT NOT NULL, " +
               "encoded_message_definition TEXT NOT NULL, type_description_hash TEXT NOT NULL);");
    for (const { type, definition } of topics)
      lines.push(`INSERT INTO message_definitions(topic_type, encoding, encoded_message_definition, type_description_hash) ` +
                 `VALUES('${type}', 'ros2msg', '${definition}', '');`);
  }
  rmSync(join(here, file), { force: true });
  spawnSync("sqlite3", ["-cmd", "PRAGMA page_size = 1024;", join(here, file)], { input: lines.join("\n") });
}

await writeMcap("run_lz4.mcap", { compressChunk: packed("lz4", ["-c", "-9"]), chunkSize: 16384 });
await writeMcap("run_zstd.mcap", { compressChunk: packed("zstd", ["-c", "-19"]), chunkSize: 1 << 20 });
writeSqlite("run.db3", false);
writeSqlite("run_defined.db3", true);
