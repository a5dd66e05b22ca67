// Validates each GLB or glTF file on the command line; fails if there are errors or warnings.
// With --codes, prints a line for each file instead: its number of errors of each code, as a JSON object.
import { readFile } from "node:fs/promises";
import { basename, dirname, join } from "node:path";
import { validateBytes } from "gltf-validator";

const asCodes = process.argv[2] === "--codes";
let failed = 0;
for (const path of process.argv.slice(asCodes ? 3 : 2)) {
  const external = async (uri) => new Uint8Array(await readFile(join(dirname(path), decodeURIComponent(uri))));
  const options = { uri: basename(path), externalResourceFunction: external, maxIssues: 0 };
  let messages;
  try {
    const report = await validateBytes(new Uint8Array(await readFile(path)), options);
    messages = report.issues.messages;
  } catch (error) {
    messages = [{ code: "NOT_A_GLTF_FILE", severity: 0, message: String(error) }];
  }
  if (asCodes) {
    const codes = {};
    for (const { code } of messages.filter((m) => m.severity === 0)) codes[code] = (codes[code] ?? 0) + 1;
    console.log(JSON.stringify(codes));
    continue;
  }
  const count = (severity) => messages.filter((m) => m.severity === severity).length;
  console.log(`${path}: ${count(0)} errors, ${count(1)} warnings`);
  for (const issue of messages.filter((m) => m.severity < 2)) {
    console.log(`  ${issue.code} at ${issue.pointer ?? issue.offset}: ${issue.message}`);
  }
  failed += count(0) + count(1) > 0 ? 1 : 0;
}
process.exit(failed === 0 ? 0 : 1);
