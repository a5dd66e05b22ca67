/** Opens files that are read as a whole. */

import { concat, iterable, open } from '../bytes.ts';
import { contentOf, type Content } from '../content.ts';
import { StriataError } from '../error.ts';
import { isContainer } from '../magic.ts';
import { registerStriata } from '../register.ts';
import { SceneTask, type SceneContext } from '../scene/scene-task.ts';
import type { StriataScene } from '../scene/scene.ts';
import { decompressed } from '../unpack.ts';
import { BuildTask } from './build-task.ts';
import { readPlain, type ReadFile } from './read.ts';

/** A file that is complete, and no longer compressed. */
export interface WholeFile {
  bytes: Uint8Array;
  name: string;
  /** The content, if the file is or contains a stream. */
  stream: Content | undefined;
}

/** Reads all bytes of a file and decompresses them. */
export async function wholeFile(content: Content, name: string, signal: AbortSignal, onBytes: (received: number) => void): Promise<WholeFile> {
  const parts: Uint8Array[] = [];
  let received = 0;
  for await (const bytes of iterable(content.chunks)) {
    parts.push(bytes);
    onBytes((received += bytes.length));
  }
  const file = await decompressed(concat(parts), name || 'file');
  const opened = await open(file.bytes.slice().buffer as ArrayBuffer, file.name, signal);
  const inner = await contentOf(opened);
  return { ...file, stream: inner.kind === 'stream' || inner.kind === 'scene' ? inner : undefined };
}

/** Reads a file without a stream. */
export function readFile({ bytes, name }: WholeFile, context: SceneContext): Promise<ReadFile> {
  if (isContainer(bytes)) throw new StriataError('unsupported', `${name} contains no stream`, 'use `loader.loadAsync(url)`');
  const { loader, module, path, manager } = context;
  return readPlain(bytes, name, {
    manager,
    path,
    configure: (gltf) => {
      registerStriata(gltf, { ...loader, wasm: module });
      loader.configure?.(gltf);
    },
  });
}

/** Opens a file without a stream: its meshes have the levels that it contains, or those that are built of them. */
export async function openWhole(file: WholeFile, context: SceneContext): Promise<StriataScene> {
  if (isContainer(file.bytes)) return new SceneTask({ ...context, kind: 'striata' }, file.bytes.length).runStored(file.bytes);
  const read = await readFile(file, context);
  const refined = read.gltf?.userData['striata'] as StriataScene | undefined;
  if (!refined) return new BuildTask(context, file.bytes.length + (read.companionBytes ?? 0)).run(read);
  refined.fill(read, []);
  refined.name = context.options.name ?? '';
  return refined;
}
