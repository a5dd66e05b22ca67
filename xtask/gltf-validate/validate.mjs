// Validates each GLB or glTF file on the command line; fails if there are errors or warnings.
import { readFile } from "node:fs/promises";
import { basename } from "node:path";
import { validateBytes } from "gltf-validator";

let failed = 0;
for (const path of process.argv.slice(2)) {
  const report = await validateBytes(new Uint8Array(await readFile(path)), { uri: basename(path) });
  const { numErrors, numWarnings, messages } = report.issues;
  console.log(`${path}: ${numErrors} errors, ${numWarnings} warnings`);
  for (const issue of messages.filter((m) => m.severity < 2)) {
    console.log(`  ${issue.code} at ${issue.pointer ?? issue.offset}: ${issue.message}`);
  }
  failed += numErrors + numWarnings > 0 ? 1 : 0;
}
process.exit(failed === 0 ? 0 : 1);
