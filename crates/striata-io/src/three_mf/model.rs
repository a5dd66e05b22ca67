//! One model part: its objects, properties and build items.

use std::collections::BTreeMap;
use std::rc::Rc;

use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion};

use super::property::{PropertyGroup, TextureGroup, color_of};
use crate::error::{Fault, Place};
use crate::report::Warnings;

/// Content of a part.
#[derive(Default)]
pub(super) struct PartModel {
    pub unit: String,
    /// Names and values in the order of the file.
    pub metadata: Vec<(String, String)>,
    pub objects: BTreeMap<u32, Object>,
    pub properties: BTreeMap<u32, PropertyGroup>,
    pub items: Vec<Component>,
}

/// An object: a mesh, or other objects.
#[derive(Default)]
pub(super) struct Object {
    pub name: String,
    /// Property of triangles that have none.
    pub property: Option<(u32, u32)>,
    pub positions: Vec<[f32; 3]>,
    pub triangles: Vec<[u32; 3]>,
    /// Property of each triangle: the group, and the entry for each corner.
    pub triangle_properties: Vec<Option<(u32, [u32; 3])>>,
    /// Shared, because other objects may use this one while it is being read.
    pub components: Rc<Vec<Component>>,
}

/// Use of an object in another one or in the build.
pub(super) struct Component {
    /// Part with the object, if it is another one.
    pub path: Option<String>,
    pub object: u32,
    /// Matrix in column order.
    pub transform: [f64; 16],
    pub place: Place,
}

/// Matrix that changes nothing.
pub(super) const IDENTITY: [f64; 16] =
    [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];

/// Reader of a part.
struct ModelReader<'a> {
    name: &'a str,
    bytes: &'a [u8],
    /// Byte of the current element.
    at: usize,
    /// A byte before it, and its line, from which lines are counted on.
    counted: (usize, u64),
    model: PartModel,
    /// The object that is being read.
    object: Option<(u32, Object)>,
    /// Identifier of the property group that is being read.
    group: Option<u32>,
    /// Numbers of elements that are not read, by name, and the place of the first.
    skipped: BTreeMap<String, (usize, Place)>,
}

/// Reads a part.
pub(super) fn read(name: &str, bytes: &[u8], warnings: &mut Warnings) -> Result<PartModel, Fault> {
    let mut reader = ModelReader {
        name,
        bytes,
        at: 0,
        counted: (0, 1),
        model: PartModel::default(),
        object: None,
        group: None,
        skipped: BTreeMap::new(),
    };
    reader.elements()?;
    for (element, (count, place)) in reader.skipped {
        warnings.push(place, format!("{count} elements `{element}` are left out"));
    }
    Ok(reader.model)
}

impl ModelReader<'_> {
    #[cold]
    fn place(&self) -> Place {
        let before = &self.bytes[..self.at.min(self.bytes.len())];
        let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count() as u64;
        Place::Part { part: self.name.to_owned(), line }
    }

    /// Returns the place like [`place`](Self::place), but counts only the lines since the last call.
    fn place_on(&mut self) -> Place {
        let (counted, line) = self.counted;
        let end = self.at.min(self.bytes.len()).max(counted);
        let line = line + self.bytes[counted..end].iter().filter(|&&byte| byte == b'\n').count() as u64;
        self.counted = (end, line);
        Place::Part { part: self.name.to_owned(), line }
    }

    #[cold]
    fn fault(&self, reason: impl Into<String>) -> Fault {
        Fault::Malformed(self.place(), reason.into())
    }

    fn elements(&mut self) -> Result<(), Fault> {
        let mut xml = Reader::from_reader(self.bytes);
        let mut is_complete = false;
        loop {
            self.at = xml.buffer_position() as usize;
            match xml.read_event() {
                Err(error) => {
                    self.at = xml.error_position() as usize;
                    return Err(self.fault(format!("the XML is malformed: {error}")));
                }
                Ok(Event::Start(start)) => {
                    let is_known = self.start(&start)?;
                    if start.local_name().as_ref() == b"metadata" {
                        let text =
                            xml.read_text(start.name()).map_err(|error| self.fault(error.to_string()))?;
                        let text = text.xml_content(XmlVersion::Implicit1_0).unwrap_or_default();
                        let text = quick_xml::escape::unescape(&text)
                            .map_or_else(|_| text.to_string(), String::from);
                        self.metadata(&start, text);
                    } else if !is_known {
                        xml.read_to_end(start.name()).map_err(|error| self.fault(error.to_string()))?;
                    }
                }
                Ok(Event::Empty(start)) => {
                    self.start(&start)?;
                    self.end(start.local_name().as_ref());
                }
                Ok(Event::End(end)) => {
                    is_complete |= end.local_name().as_ref() == b"model";
                    self.end(end.local_name().as_ref());
                }
                Ok(Event::Eof) => break,
                Ok(_) => {}
            }
        }
        if is_complete { Ok(()) } else { Err(self.fault("the part ends before the model does")) }
    }

    /// Reads the start of an element; false if it is unknown and has to be skipped.
    fn start(&mut self, start: &BytesStart<'_>) -> Result<bool, Fault> {
        match start.local_name().as_ref() {
            b"vertex" => self.vertex(start)?,
            b"triangle" => self.triangle(start)?,
            b"model" => {
                self.model.unit = attribute(start, "unit").unwrap_or_else(|| "millimeter".to_owned());
            }
            b"object" => {
                let id = self.required(start, "id")?;
                let group = self.optional(start, "pid")?;
                let property = group.zip(self.optional(start, "pindex")?.or(Some(0)));
                let name =
                    attribute(start, "name").or_else(|| attribute(start, "partnumber")).unwrap_or_default();
                self.object = Some((id, Object { name, property, ..Object::default() }));
            }
            b"component" => {
                let component = self.component(start)?;
                let components =
                    self.object.as_mut().and_then(|(_, object)| Rc::get_mut(&mut object.components));
                match components {
                    Some(components) => components.push(component),
                    None => return Err(self.fault("a component outside of an object")),
                }
            }
            b"item" => {
                let item = self.component(start)?;
                self.model.items.push(item);
            }
            b"basematerials" => self.open_group(start, PropertyGroup::Materials(Vec::new()))?,
            b"colorgroup" => self.open_group(start, PropertyGroup::Colors(Vec::new()))?,
            b"texture2dgroup" => {
                let texture = self.required(start, "texid")?;
                self.open_group(
                    start,
                    PropertyGroup::Texture(TextureGroup { texture, coordinates: Vec::new() }),
                )?;
            }
            b"texture2d" => {
                let text = |name: &str| attribute(start, name).unwrap_or_default();
                let wraps = [text("tilestyleu"), text("tilestylev")];
                self.open_group(start, PropertyGroup::Image { path: text("path"), wraps })?;
            }
            b"base" | b"color" | b"tex2coord" => self.entry(start)?,
            b"resources" | b"mesh" | b"vertices" | b"triangles" | b"components" | b"build" | b"metadata"
            | b"metadatagroup" => {}
            other => {
                let name = String::from_utf8_lossy(&other[..other.len().min(40)]).into_owned();
                match self.skipped.get_mut(&name) {
                    Some((count, _)) => *count += 1,
                    None => {
                        let place = self.place();
                        self.skipped.insert(name, (1, place));
                    }
                }
                return Ok(false);
            }
        }
        Ok(true)
    }

    fn end(&mut self, name: &[u8]) {
        match name {
            b"object" => {
                if let Some((id, object)) = self.object.take() {
                    self.model.objects.insert(id, object);
                }
            }
            b"basematerials" | b"colorgroup" | b"texture2dgroup" | b"texture2d" => self.group = None,
            _ => {}
        }
    }

    fn metadata(&mut self, start: &BytesStart<'_>, text: String) {
        let name = attribute(start, "name").unwrap_or_default();
        if self.object.is_none() && !name.is_empty() {
            self.model.metadata.push((name, text));
        }
    }

    fn vertex(&mut self, start: &BytesStart<'_>) -> Result<(), Fault> {
        let mut position = [None; 3];
        for found in start.attributes().with_checks(false).flatten() {
            let axis = match found.key.as_ref() {
                b"x" => 0,
                b"y" => 1,
                b"z" => 2,
                _ => continue,
            };
            let text = std::str::from_utf8(&found.value).ok();
            position[axis] = text.and_then(|text| text.trim().parse::<f32>().ok().filter(|x| x.is_finite()));
        }
        match (position, &mut self.object) {
            ([Some(x), Some(y), Some(z)], Some((_, object))) => object.positions.push([x, y, z]),
            (_, None) => return Err(self.fault("a vertex outside of an object")),
            _ => return Err(self.fault("a vertex without the three numbers x, y and z")),
        }
        Ok(())
    }

    fn triangle(&mut self, start: &BytesStart<'_>) -> Result<(), Fault> {
        let (mut corners, mut entries, mut group) = ([None; 3], [None; 3], None);
        for found in start.attributes().with_checks(false).flatten() {
            let text = std::str::from_utf8(&found.value).ok();
            let number = text.and_then(|text| text.trim().parse::<u32>().ok());
            match found.key.as_ref() {
                b"v1" => corners[0] = number,
                b"v2" => corners[1] = number,
                b"v3" => corners[2] = number,
                b"p1" => entries[0] = number,
                b"p2" => entries[1] = number,
                b"p3" => entries[2] = number,
                b"pid" => group = number,
                _ => {}
            }
        }
        let Some((_, object)) = &mut self.object else {
            return Err(self.fault("a triangle outside of an object"));
        };
        let [Some(a), Some(b), Some(c)] = corners else {
            return Err(self.fault("a triangle without the three numbers v1, v2 and v3"));
        };
        let count = object.positions.len();
        if let Some(vertex) = [a, b, c].into_iter().find(|&vertex| vertex as usize >= count) {
            let number = object.triangles.len();
            return Err(self.fault(format!("triangle {number}: vertex {vertex} of {count} does not exist")));
        }
        let group = group.or(object.property.map(|(group, _)| group));
        let usual = object.property.map(|(_, entry)| [entry; 3]);
        let own = entries[0].map(|first| [first, entries[1].unwrap_or(first), entries[2].unwrap_or(first)]);
        object.triangles.push([a, b, c]);
        object.triangle_properties.push(group.zip(own.or(usual)));
        Ok(())
    }

    fn component(&mut self, start: &BytesStart<'_>) -> Result<Component, Fault> {
        let transform = match attribute(start, "transform") {
            None => IDENTITY,
            Some(text) => {
                let numbers: Option<Vec<f64>> =
                    text.split_whitespace().map(|word| word.parse().ok()).collect();
                match numbers.filter(|n| n.len() == 12 && n.iter().all(|x| x.is_finite())) {
                    Some(n) => std::array::from_fn(|i| match i % 4 {
                        3 => f64::from(u8::from(i == 15)),
                        row => n[i / 4 * 3 + row],
                    }),
                    None => return Err(self.fault("`transform` is not 12 numbers")),
                }
            }
        };
        let object = self.required(start, "objectid")?;
        let path = start
            .attributes()
            .with_checks(false)
            .flatten()
            .find(|found| found.key.local_name().as_ref() == b"path");
        let path = path.map(|found| String::from_utf8_lossy(&found.value).into_owned());
        let place = self.place_on();
        Ok(Component { path, object, transform, place })
    }

    fn open_group(&mut self, start: &BytesStart<'_>, property: PropertyGroup) -> Result<(), Fault> {
        let id = self.required(start, "id")?;
        self.model.properties.insert(id, property);
        self.group = Some(id);
        Ok(())
    }

    /// Reads an entry of a property group.
    fn entry(&mut self, start: &BytesStart<'_>) -> Result<(), Fault> {
        let color = |name: &str| attribute(start, name).and_then(|text| color_of(&text));
        let number = |name: &str| {
            attribute(start, name).and_then(|text| text.trim().parse::<f32>().ok().filter(|x| x.is_finite()))
        };
        let group = self.group.and_then(|id| self.model.properties.get_mut(&id));
        let is_read = match group {
            Some(PropertyGroup::Materials(entries)) => color("displaycolor").map(|color| {
                entries.push((attribute(start, "name").unwrap_or_default(), color));
            }),
            Some(PropertyGroup::Colors(entries)) => color("color").map(|color| entries.push(color)),
            Some(PropertyGroup::Texture(group)) => {
                number("u").zip(number("v")).map(|(u, v)| group.coordinates.push([u, v]))
            }
            _ => None,
        };
        is_read.ok_or_else(|| self.fault("expected a color such as #FF8000, or the numbers u and v"))
    }

    fn required(&self, start: &BytesStart<'_>, name: &str) -> Result<u32, Fault> {
        self.optional(start, name)?.ok_or_else(|| self.fault(format!("the attribute `{name}` is missing")))
    }

    fn optional(&self, start: &BytesStart<'_>, name: &str) -> Result<Option<u32>, Fault> {
        let Some(text) = attribute(start, name) else { return Ok(None) };
        let number = text.trim().parse();
        number.map(Some).map_err(|_| self.fault(format!("the attribute `{name}` is not a whole number")))
    }
}

/// Returns the value of an attribute.
pub(super) fn attribute(start: &BytesStart<'_>, name: &str) -> Option<String> {
    let found = start.try_get_attribute(name).ok()??;
    Some(found.normalized_value(XmlVersion::Implicit1_0).ok()?.into_owned())
}
