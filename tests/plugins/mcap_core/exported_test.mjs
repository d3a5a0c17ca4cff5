// What `lacuna export ... trace.mcap` writes, read by @mcap/core, has the numbers of `trace.csv`. LACUNA_PROGRAM names the
// program, LACUNA_SOURCE the source tree.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";

import { readMcap } from "./read_mcap.mjs";

const folder = mkdtempSync(path.join(tmpdir(), "lacuna-mcap-"));
const lacuna = (...words) => execFileSync(process.env.LACUNA_PROGRAM, words, { cwd: folder, stdio: "pipe" });
try {
  for (const name of ["first-steps.toml", "robots", "data"])
    cpSync(path.join(process.env.LACUNA_SOURCE, "experiments", name), path.join(folder, name), { recursive: true });
  lacuna("compare", "first-steps.toml");
  for (const file of ["trace.mcap", "trace.csv"]) lacuna("export", "first-steps.db", "chirp.csv", file);

  const [head, ...rows] = readFileSync(path.join(folder, "trace.csv"), "utf8").trim().split("\n").map((line) => line.split(","));
  assert.deepEqual(head, ["time [s]", "angle measured [rad]", "angle predicted [rad]"]);
  const topics = await readMcap(path.join(folder, "trace.mcap"));
  assert.ok(topics.has("/angle"), [...topics.keys()].join(", "));
  const { messages } = topics.get("/angle");
  assert.ok(rows.length > 1000);
  assert.equal(messages.length, rows.length);
  for (const [i, { time, measured, predicted }] of messages.entries())
    assert.deepEqual([time, measured, predicted], rows[i].map(Number), `row ${i}`);
  console.log(`${messages.length} messages of /angle, equal to trace.csv`);
} finally {
  rmSync(folder, { recursive: true });
}
