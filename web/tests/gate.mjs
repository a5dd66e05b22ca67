// A line to the server that lets through as many bytes of a model as a test says, and can break.
//
// A line of so many bytes a second would prove nothing on a machine that is slower than it: all bytes would be there before
// the page has begun. Here the page gets a tenth of the bytes and no more until it has drawn them.

import { once } from 'node:events';
import { createServer, request } from 'node:http';

/** Stands between page and server; `allow` counts over all models that are asked for. */
export class Gate {
  #allowed = 0;
  #passed = 0;
  #waiting = new Set();
  #answers = new Set();
  #server;

  static async to(url) {
    const gate = new Gate();
    gate.#server = createServer((asked, answer) => gate.#pass(new URL(url), asked, answer));
    gate.#server.listen(0, '127.0.0.1');
    await once(gate.#server, 'listening');
    gate.url = `http://127.0.0.1:${gate.#server.address().port}/`;
    return gate;
  }

  /** From now on so many bytes of models in all. */
  allow(bytes) {
    this.#allowed = bytes;
    for (const wake of this.#waiting) wake();
    this.#waiting.clear();
  }

  /** Breaks the connections of models that are on their way. */
  cut() {
    for (const answer of this.#answers) answer.destroy();
  }

  close() {
    this.#server.close();
    this.#server.closeAllConnections();
  }

  #pass({ hostname, port }, asked, answer) {
    const { method, url: path } = asked;
    const onward = request({ hostname, port, method, path, headers: asked.headers }, (response) => {
      answer.writeHead(response.statusCode, response.headers);
      if (path.startsWith('/models/')) this.#meter(response, answer).catch(() => answer.destroy());
      else response.pipe(answer);
    });
    onward.on('error', () => answer.destroy());
    answer.on('close', () => onward.destroy());
    asked.pipe(onward);
  }

  async #meter(response, answer) {
    this.#answers.add(answer);
    answer.on('close', () => this.#answers.delete(answer));
    for await (const chunk of response) {
      for (let from = 0; from < chunk.length; ) {
        while (this.#passed >= this.#allowed && !answer.destroyed) await new Promise((wake) => this.#waiting.add(wake));
        if (answer.destroyed) return;
        const to = Math.min(chunk.length, from + this.#allowed - this.#passed);
        this.#passed += to - from;
        answer.write(chunk.subarray(from, to));
        from = to;
      }
    }
    answer.end();
  }
}
