/** gzip and zstd around a file: taken off by the browser, or by a small script. */
/** The bytes without what they are packed in, and the name without its extension. */
export declare function unpacked(bytes: Uint8Array, name: string): Promise<{
    bytes: Uint8Array;
    name: string;
}>;
