// A proxy that passes on only as many bytes of a model as a test allows, and can break the connection.
//
// Limiting the rate instead would prove nothing on a slow machine: all bytes would have arrived before the page had started. With this
// proxy, the page gets a tenth of the bytes, and no more until it has drawn them.

import { once } from 'node:events';
import { createServer, request } from 'node:http';

/** Proxy between page and server; `allow` counts the bytes of all requested models together. */
export class Gate {
  #allowed = 0;
  #passed = 0;
  #waiting = new Set();
  #responses = new Set();
  #server;

  static async to(url) {
    const gate = new Gate();
    gate.#server = createServer((incoming, outgoing) => gate.#forward(new URL(url), incoming, outgoing));
    gate.#server.listen(0, '127.0.0.1');
    await once(gate.#server, 'listening');
    gate.url = `http://127.0.0.1:${gate.#server.address().port}/`;
    return gate;
  }

  /** Allows this many bytes of models in total. */
  allow(bytes) {
    this.#allowed = bytes;
    for (const wake of this.#waiting) wake();
    this.#waiting.clear();
  }

  /** Breaks the connections of models that are loading. */
  cut() {
    for (const outgoing of this.#responses) outgoing.destroy();
  }

  close() {
    this.#server.close();
    this.#server.closeAllConnections();
  }

  #forward({ hostname, port }, incoming, outgoing) {
    const { method, url: path } = incoming;
    const upstream = request({ hostname, port, method, path, headers: incoming.headers }, (response) => {
      outgoing.writeHead(response.statusCode, response.headers);
      if (path.startsWith('/models/')) this.#meter(response, outgoing).catch(() => outgoing.destroy());
      else response.pipe(outgoing);
    });
    upstream.on('error', () => outgoing.destroy());
    outgoing.on('close', () => upstream.destroy());
    incoming.pipe(upstream);
  }

  async #meter(response, outgoing) {
    this.#responses.add(outgoing);
    outgoing.on('close', () => this.#responses.delete(outgoing));
    for await (const chunk of response) {
      for (let from = 0; from < chunk.length; ) {
        while (this.#passed >= this.#allowed && !outgoing.destroyed) await new Promise((wake) => this.#waiting.add(wake));
        if (outgoing.destroyed) return;
        const to = Math.min(chunk.length, from + this.#allowed - this.#passed);
        this.#passed += to - from;
        outgoing.write(chunk.subarray(from, to));
        from = to;
      }
    }
    outgoing.end();
  }
}
