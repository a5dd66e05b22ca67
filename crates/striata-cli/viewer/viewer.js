// The models of the folder, to look at and to download.
const list = document.getElementById('models');
try {
  const answer = await fetch('models.json');
  if (!answer.ok) throw new Error(`models.json: ${answer.status}`);
  const { name, models } = await answer.json();
  document.getElementById('name').textContent = name;
  for (const model of models) {
    const picture = Object.assign(new Image(), { src: model.picture, alt: '', loading: 'lazy', width: 320, height: 240 });
    const link = Object.assign(document.createElement('a'), { href: model.url, textContent: model.path, download: model.name });
    const facts = document.createElement('span');
    const count = model.triangle_count === null ? '' : `, ${model.triangle_count.toLocaleString()} triangles`;
    facts.textContent = `${model.bytes.toLocaleString()} bytes${count}`;
    const item = document.createElement('li');
    item.append(picture, link, facts);
    list.append(item);
  }
} catch (error) {
  list.replaceWith(document.createTextNode(`No list of models: ${error.message}`));
}
