/** Recognizes files by their first bytes. */

const STREAM = [0x89, 0x53, 0x54, 0x52];
const SCENE = [0x89, 0x53, 0x43, 0x4e];
const CONTAINER = [...'STRIATA\0'].map((character) => character.charCodeAt(0));
const PAGED = [...'striataP'].map((character) => character.charCodeAt(0));
const GLB = [...'glTF'].map((character) => character.charCodeAt(0));

/** Number of bytes that suffice to recognize a file. */
export const MAGIC_BYTES = CONTAINER.length;

const startsWith = (bytes: Uint8Array, magic: number[]) => magic.every((byte, at) => bytes[at] === byte);

/** Whether the bytes begin the stream of a single mesh. */
export const isStream = (bytes: Uint8Array) => startsWith(bytes, STREAM);
/** Whether the bytes begin the stream of a scene. */
export const isSceneStream = (bytes: Uint8Array) => startsWith(bytes, SCENE);
/** Whether the bytes begin a `.striata` file. */
export const isContainer = (bytes: Uint8Array) => startsWith(bytes, CONTAINER);
/** Whether the bytes begin a file of pages. */
export const isPaged = (bytes: Uint8Array) => startsWith(bytes, PAGED);
/** Whether the bytes begin a web page. */
export const isWebPage = (bytes: Uint8Array) => /^\s*<(?:!doct|html)/i.test(String.fromCharCode(...bytes.subarray(0, MAGIC_BYTES)));
/** Whether the bytes begin a binary glTF file. */
export const isGlb = (bytes: Uint8Array) => startsWith(bytes, GLB);
