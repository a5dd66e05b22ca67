/** Opens files that are dropped on the page or chosen in the file dialog. */

import { element, input } from './dom.ts';

/** Calls `open` with each file that is dropped or chosen; only the first file of a drop is used. */
export function acceptFiles(open: (file: File) => void): void {
  const picker = input('file');
  for (const id of ['open', 'welcome-open']) element(id).addEventListener('click', () => picker.click());
  picker.addEventListener('change', () => {
    const file = picker.files?.[0];
    // Lets the same file be chosen again.
    picker.value = '';
    if (file) open(file);
  });
  const overlay = element('drop');
  let depth = 0;
  const show = (isOver: boolean): void => {
    overlay.hidden = !isOver;
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
