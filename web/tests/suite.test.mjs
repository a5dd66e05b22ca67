// Tests the viewer in a browser, served by a real `striata serve`. Run with `node tests/run.mjs`.

import { after, before, describe } from 'node:test';
import batches from './batches.mjs';
import detail from './detail.mjs';
import errors from './errors.mjs';
import examples from './examples.mjs';
import files from './files.mjs';
import { world } from './harness.mjs';
import inspecting from './inspecting.mjs';
import looks from './looks.mjs';
import models from './models.mjs';
import opening from './opening.mjs';
import paged from './paged.mjs';
import phone from './phone.mjs';
import pictures from './pictures.mjs';
import references from './references.mjs';
import saving from './saving.mjs';
import sceneViewer from './scene-viewer.mjs';
import scenes from './scenes.mjs';
import sharing from './sharing.mjs';
import speed from './speed.mjs';
import streaming from './streaming.mjs';
import views from './views.mjs';

describe('viewer', { concurrency: 1 }, () => {
  const shared = {};
  before(async () => void Object.assign(shared, await world()), { timeout: 1_200_000 });
  after(() => shared.end?.(), { timeout: 600_000 });
  const viewer = [streaming, detail, views, files, opening, paged, sceneViewer, saving, errors, looks, sharing, pictures, inspecting, models, phone];
  for (const group of [...viewer, scenes, batches, references, examples, speed]) group(shared);
});
