/** Files that are dropped on the page or picked. */

import { element, input } from './page.ts';

/** Calls `open` with each file the reader gives; further files of one drop are left out. */
export function takeFiles(open: (file: File) => void): void {
  const picker = input('file');
  for (const id of ['open', 'welcome-open']) element(id).addEventListener('click', () => picker.click());
  picker.addEventListener('change', () => {
    const file = picker.files?.[0];
    // The same file can be picked again.
    picker.value = '';
    if (file) open(file);
  });
  const shade = element('drop');
  let depth = 0;
  const show = (isOver: boolean): void => {
    shade.hidden = !isOver;
    if (!isOver) depth = 0;
  };
  document.addEventListener('dragenter', (event) => {
    if (!hasFiles(event)) return;
    depth += 1;
    show(true);
  });
  document.addEventListener('dragleave', () => {
    depth -= 1;
    if (depth <= 0) show(false);
  });
  document.addEventListener('dragover', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    if (event.dataTransfer) event.dataTransfer.dropEffect = 'copy';
  });
  document.addEventListener('drop', (event) => {
    show(false);
    const file = event.dataTransfer?.files[0];
    if (!file) return;
    event.preventDefault();
    open(file);
  });
}

function hasFiles(event: DragEvent): boolean {
  return event.dataTransfer?.types.includes('Files') ?? false;
}
