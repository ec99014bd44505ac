// SPDX-License-Identifier: GPL-3.0-or-later
// Shows the scene of a page written by io/html_view. window.dscView lets a page's own script steer it.
'use strict';
(function () {
  const scene = JSON.parse(document.getElementById('scene').textContent);
  const element = id => document.getElementById(id);

  function make(tag, parent, text) {
    const node = document.createElement(tag);
    if (text !== undefined) node.textContent = text;
    if (parent) parent.appendChild(node);
    return node;
  }

  for (const [name, value] of scene.facts) {
    const row = make('tr', element('facts'));
    make('td', row, name);
    make('td', row, value);
  }
  if (scene.figure) {
    const figure = make('img', element('figure'));
    figure.alt = scene.title;
    figure.src = 'data:image/svg+xml,' + encodeURIComponent(scene.figure);
  }

  let renderer;
  try {
    renderer = new THREE.WebGLRenderer({ antialias: true });
  } catch (problem) {
    make('div', element('canvas'), 'This browser shows no 3D pictures (WebGL is not available).').className = 'problem';
    return;
  }
  const canvas = renderer.domElement;
  renderer.setPixelRatio(window.devicePixelRatio);
  renderer.setClearColor(0xffffff);
  element('canvas').appendChild(canvas);

  // Lines and dots lie in the surface they are drawn on, which the triangles only approximate: they are drawn as if they
  // were nearer to the eye by this fraction of their distance.
  const depthShift = 'gl_Position.z += 0.004 * projectionMatrix[3][2];';
  const lineMaterials = [];

  function lineMaterial(colour, width) {
    const material = new THREE.LineMaterial({ color: new THREE.Color(colour).getHex(), linewidth: width });
    material.vertexShader = material.vertexShader.replace('gl_Position = clip;', 'gl_Position = clip;' + depthShift);
    lineMaterials.push(material);
    return material;
  }

  // Pairs of end points of the segments of lines given as [x, y, z, x, y, z, …]; null interrupts a line.
  function segmentsOf(lines) {
    const positions = [];
    for (const line of lines) {
      for (let i = 3; i < line.length; i += 3) {
        let complete = true;
        for (let k = i - 3; k < i + 3; ++k) complete = complete && line[k] !== null;
        if (complete) for (let k = i - 3; k < i + 3; ++k) positions.push(line[k]);
      }
    }
    return positions;
  }

  function lineObject(lines, material) {
    const positions = segmentsOf(lines);
    if (positions.length === 0) return new THREE.Group();
    const geometry = new THREE.LineSegmentsGeometry();
    geometry.setPositions(positions);
    const object = new THREE.LineSegments2(geometry, material);
    object.frustumCulled = false;
    object.renderOrder = 1;
    return object;
  }

  function discTexture() {
    const disc = document.createElement('canvas');
    disc.width = disc.height = 64;
    const context = disc.getContext('2d');
    context.fillStyle = '#fff';
    context.beginPath();
    context.arc(32, 32, 31, 0, 2 * Math.PI);
    context.fill();
    return new THREE.CanvasTexture(disc);
  }
  const disc = discTexture();

  function pointObject(positions, colour, size) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
    const material = new THREE.PointsMaterial({ color: colour, size: size * window.devicePixelRatio, map: disc,
                                                alphaTest: 0.5, sizeAttenuation: false });
    material.onBeforeCompile = shader => {
      shader.vertexShader = shader.vertexShader.replace('#include <logdepthbuf_vertex>',
                                                        '#include <logdepthbuf_vertex>\n' + depthShift);
    };
    const object = new THREE.Points(geometry, material);
    object.frustumCulled = false;
    object.renderOrder = 2;
    return object;
  }

  // Triangles and their edges, with vertex colours where `colour` is null.
  function triangleObject(geometry, colour, showsEdges, isFlat) {
    const settings = { color: colour === null ? '#ffffff' : colour, side: THREE.DoubleSide,
                       vertexColors: colour === null ? THREE.VertexColors : THREE.NoColors,
                       polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 8 };
    const material = isFlat ? new THREE.MeshBasicMaterial(settings) : new THREE.MeshLambertMaterial(settings);
    const object = new THREE.Mesh(geometry, material);
    const edges = new THREE.LineSegments(new THREE.WireframeGeometry(geometry),
                                         new THREE.LineBasicMaterial({ color: 0x000000, transparent: true, opacity: 0.35 }));
    edges.visible = showsEdges;
    object.add(edges);
    object.setOpacity = opacity => {
      material.opacity = opacity;
      material.transparent = opacity < 1;
      material.depthWrite = opacity >= 1;
      material.needsUpdate = true;
    };
    return object;
  }

  function noTriangles() {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute([], 3));
    return geometry;
  }

  function surfaceObject(surface, isFlat) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(surface.vertices, 3));
    geometry.setIndex(new THREE.Uint32BufferAttribute(surface.triangles, 1));
    geometry.computeVertexNormals();
    const hasColours = surface.colours.length > 0;
    if (hasColours) geometry.setAttribute('color', new THREE.Float32BufferAttribute(surface.colours, 3));
    const object = triangleObject(geometry, hasColours ? null : surface.colour, surface.edges, isFlat);
    object.setOpacity(surface.opacity);
    return object;
  }

  // From the worst value to the best one.
  const scaleColours = ['#a8102a', '#ee6c3b', '#f7d774', '#9cc9dd', '#3b6fb0'];
  const scaleGradient = `linear-gradient(to right, ${scaleColours.join(', ')})`;

  function scaleColour(fraction) {
    const at = (scaleColours.length - 1) * Math.max(0, Math.min(1, fraction));
    const below = Math.min(Math.floor(at), scaleColours.length - 2);
    return new THREE.Color(scaleColours[below]).lerp(new THREE.Color(scaleColours[below + 1]), at - below);
  }

  // What is cut away, the same in all views, so that they can be compared.
  const cut = { axis: 1, position: 0.5, limit: 1 };
  // The side that goes is the one that the camera stands on at first.
  const cutSides = [1, -1, 1];

  // A colour has to be found again on the scale: no lamps, but a little shade, to tell the faces of a cell apart.
  const shadeOf = (x, y, z) => 0.8 + 0.2 * Math.abs(0.35 * x - 0.55 * y + 0.76 * z);

  function tetsObject(item) {
    const object = triangleObject(noTriangles(), null, item.edges, true);
    const vertices = Float32Array.from(item.vertices);
    const tets = Uint32Array.from(item.tets);
    const beyond = dscTets.neighbours(tets, vertices.length / 3);
    const centres = dscTets.centres(tets, vertices);
    const colours = item.values.map(value => scaleColour((value - item.worst) / (item.best - item.worst)));
    const box = new THREE.Box3().setFromArray(vertices);
    const isShown = new Uint8Array(item.values.length);
    object.frustumCulled = object.children[0].frustumCulled = false;

    object.cutOpen = () => {
      const lower = box.min.getComponent(cut.axis);
      const upper = box.max.getComponent(cut.axis);
      const side = cutSides[cut.axis];
      const plane = side > 0 ? upper + cut.position * (lower - upper) : lower + cut.position * (upper - lower);
      const limit = cut.limit < 1 ? item.worst + cut.limit * (item.best - item.worst) : Infinity;
      for (let t = 0; t < isShown.length; ++t) {
        isShown[t] = side * (centres[3 * t + cut.axis] - plane) <= 0 && item.values[t] <= limit;
      }
      const shell = dscTets.shell(tets, beyond, isShown);
      const positions = new Float32Array(3 * shell.corners.length);
      shell.corners.forEach((vertex, i) => positions.set(vertices.subarray(3 * vertex, 3 * vertex + 3), 3 * i));
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
      geometry.computeVertexNormals();
      const normals = geometry.attributes.normal.array;
      const cornerColours = new Float32Array(positions.length);
      shell.corners.forEach((vertex, i) => {
        const shade = shadeOf(normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]);
        colours[shell.tets[Math.floor(i / 3)]].clone().multiplyScalar(shade).toArray(cornerColours, 3 * i);
      });
      geometry.setAttribute('color', new THREE.BufferAttribute(cornerColours, 3));
      for (const part of [object, object.children[0]]) part.geometry.dispose();
      object.geometry = geometry;
      object.children[0].geometry = new THREE.WireframeGeometry(geometry);
      object.shownTets = shell.tets;
    };
    object.labelOf = triangle => {
      const t = object.shownTets[triangle];
      const centre = Array.from(centres.subarray(3 * t, 3 * t + 3), x => Number(x.toPrecision(5)));
      return `${item.valueName} ${item.values[t]}\nat (${centre.join(', ')})`;
    };
    object.setOpacity(1);
    return object;
  }

  // A surface that is another one at each time: faces are shaded flat, so that sharp edges are seen.
  function surfaceSeriesObject(item, isFlat) {
    const object = triangleObject(noTriangles(), item.colour, item.edges, isFlat);
    object.frustumCulled = object.children[0].frustumCulled = false;
    object.show = frame => {
      const surface = frame < 0 ? { vertices: [], triangles: [] } : item.frames[frame];
      const positions = new Float32Array(3 * surface.triangles.length);
      surface.triangles.forEach((v, i) => {
        for (let k = 0; k < 3; ++k) positions[3 * i + k] = surface.vertices[3 * v + k];
      });
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
      geometry.computeVertexNormals();
      for (const part of [object, object.children[0]]) part.geometry.dispose();
      object.geometry = geometry;
      object.children[0].geometry = new THREE.WireframeGeometry(geometry);
    };
    object.setOpacity(item.opacity);
    return object;
  }

  // Everything of one view: its objects, camera, controls and what is picked in it.
  function buildView(description) {
    const root = new THREE.Scene();
    const view = { description, root, items: [], series: [], surfaces: [], picked: new THREE.Group() };
    const addItem = (item, object) => {
      object.visible = item.visible;
      root.add(object);
      view.items.push({ name: item.name, colour: item.colour, object });
    };

    for (const surface of description.surfaces) {
      const object = surfaceObject(surface, description.flat);
      view.surfaces.push(object);
      addItem(surface, object);
    }
    if (description.tets) {
      view.tets = tetsObject(description.tets);
      view.surfaces.push(view.tets);
      addItem({ name: description.tets.name, colour: scaleGradient, visible: true }, view.tets);
    }
    for (const item of description.lines) addItem(item, lineObject(item.lines, lineMaterial(item.colour, item.width)));
    for (const item of description.series) {
      const holder = new THREE.Group();
      const material = lineMaterial(item.colour, item.width);
      const show = frame => replaceContent(holder, frame < 0 ? [] : [lineObject(item.frames[frame], material)]);
      view.series.push({ item, show, shown: -2 });
      addItem(item, holder);
    }
    for (const item of description.surfaceSeries) {
      const object = surfaceSeriesObject(item, description.flat);
      view.series.push({ item, show: object.show, shown: -2 });
      view.surfaces.push(object);
      addItem(item, object);
    }
    for (const item of description.points) addItem(item, pointObject(item.positions, item.colour, item.size));
    root.add(view.picked);
    if (description.fan) {
      view.fanMaterial = lineMaterial(description.fan.colour, description.fan.width);
      view.items.push({ name: description.fan.name, colour: description.fan.colour, object: view.picked });
    }
    view.times = Array.from(new Set([].concat(...view.series.map(series => series.item.times)))).sort((a, b) => a - b);
    placeCamera(view);
    return view;
  }

  function boundsOf(view) {
    const box = new THREE.Box3();
    const point = new THREE.Vector3();
    const extend = numbers => {
      for (let i = 0; i + 2 < numbers.length; i += 3) {
        if (numbers[i] !== null && numbers[i + 1] !== null && numbers[i + 2] !== null) {
          box.expandByPoint(point.set(numbers[i], numbers[i + 1], numbers[i + 2]));
        }
      }
    };
    for (const surface of view.description.surfaces) extend(surface.vertices);
    if (view.description.tets) extend(view.description.tets.vertices);
    for (const item of view.description.lines) item.lines.forEach(extend);
    for (const item of view.description.points) extend(item.positions);
    for (const item of view.description.series) item.frames.forEach(frame => frame.forEach(extend));
    for (const item of view.description.surfaceSeries) item.frames.forEach(frame => extend(frame.vertices));
    if (box.isEmpty()) box.set(new THREE.Vector3(-1, -1, -1), new THREE.Vector3(1, 1, 1));
    return box;
  }

  function placeCamera(view) {
    const box = boundsOf(view);
    const center = box.getCenter(new THREE.Vector3());
    view.size = box.getSize(new THREE.Vector3());
    const radius = Math.max(0.5 * view.size.length(), 1e-12);
    if (view.description.flat) {
      view.camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0, 4 * radius);
      view.camera.position.copy(center).z += 2 * radius;
    } else {
      view.camera = new THREE.PerspectiveCamera(35, 1, radius / 50, radius * 50);
      view.camera.up.set(0, 0, 1);
      view.camera.position.set(1.6, -2.6, 2.0).setLength(3.3 * radius).add(center);
      view.camera.add(new THREE.DirectionalLight(0xffffff, 0.75));
      view.root.add(new THREE.HemisphereLight(0xffffff, 0x8890a0, 0.45));
    }
    view.root.add(view.camera);
    view.controls = new THREE.OrbitControls(view.camera, canvas);
    view.controls.target.copy(center);
    view.controls.screenSpacePanning = true;
    view.controls.enableKeys = false;
    if (view.description.flat) {
      view.controls.enableRotate = false;
      view.controls.mouseButtons.LEFT = THREE.MOUSE.PAN;
      view.controls.touches.ONE = THREE.TOUCH.PAN;
    }
    view.controls.update();
    view.controls.enabled = false;
    view.controls.addEventListener('change', draw);
  }

  function fitCamera(view, width, height) {
    const camera = view.camera;
    if (camera.isPerspectiveCamera) {
      camera.aspect = width / height;
      // A tall, narrow window sees as much to the sides as a wide one sees above.
      camera.fov = 35 * Math.max(1, Math.min(2.5, height / width));
    } else {
      const half = 0.54 * Math.max(view.size.y, view.size.x * height / width, 1e-12);
      camera.top = half;
      camera.bottom = -half;
      camera.right = half * width / height;
      camera.left = -camera.right;
    }
    camera.updateProjectionMatrix();
  }

  let current = null;
  let isDrawn = true;

  function draw() {
    if (!isDrawn) return;
    isDrawn = false;
    requestAnimationFrame(() => {
      isDrawn = true;
      renderer.render(current.root, current.camera);
    });
  }

  function resize() {
    const width = Math.max(element('canvas').clientWidth, 1);
    const height = Math.max(element('canvas').clientHeight, 1);
    renderer.setSize(width, height);
    for (const material of lineMaterials) material.resolution.set(width, height);
    for (const view of views) fitCamera(view, width, height);
    draw();
  }

  function replaceContent(group, objects) {
    for (const old of group.children.slice()) {
      group.remove(old);
      if (old.geometry) old.geometry.dispose();
    }
    for (const object of objects) group.add(object);
  }

  function setTime(time) {
    for (const series of current.series) {
      let frame = -1;
      while (frame + 1 < series.item.times.length && series.item.times[frame + 1] <= time) ++frame;
      if (frame === series.shown) continue;
      series.shown = frame;
      series.show(frame);
    }
    draw();
  }

  // The sample of the fan nearest to a place: its ray is shown up to there.
  function pick(place) {
    const fan = current.description.fan;
    let best = { distance: Infinity };
    fan.rays.forEach((ray, index) => {
      for (let i = 0; i + 2 < ray.length; i += 3) {
        if (ray[i] === null) continue;
        const distance = (ray[i] - place.x) ** 2 + (ray[i + 1] - place.y) ** 2 + (ray[i + 2] - place.z) ** 2;
        if (distance < best.distance) best = { distance, index, sample: i / 3 };
      }
    });
    if (best.index === undefined) return;
    const ray = fan.rays[best.index].slice(0, 3 * best.sample + 3);
    replaceContent(current.picked, [lineObject([ray], current.fanMaterial),
                                    pointObject(ray.slice(-3), fan.colour, 10)]);
    element('picked').textContent = `${fan.labels[best.index]}\n${fan.valueName} ${fan.values[best.index][best.sample]}`;
    draw();
  }

  function labelledPointAt(x, y) {
    const rectangle = canvas.getBoundingClientRect();
    let best = null;
    let nearest = 10;
    for (const item of current.description.points) {
      for (let i = 0; i < item.labels.length; ++i) {
        const p = new THREE.Vector3().fromArray(item.positions, 3 * i).project(current.camera);
        const distance = Math.hypot((p.x + 1) / 2 * rectangle.width - x, (1 - p.y) / 2 * rectangle.height - y);
        if (distance < nearest) {
          nearest = distance;
          best = item.labels[i];
        }
      }
    }
    return best;
  }

  function click(x, y) {
    const label = labelledPointAt(x, y);
    if (label !== null) {
      element('picked').textContent = label;
      return;
    }
    if (!current.description.fan && !current.tets) return;
    const rectangle = canvas.getBoundingClientRect();
    const pointer = new THREE.Vector2(2 * x / rectangle.width - 1, 1 - 2 * y / rectangle.height);
    const caster = new THREE.Raycaster();
    caster.setFromCamera(pointer, current.camera);
    if (current.tets) {
      const [hit] = caster.intersectObject(current.tets);
      element('picked').textContent = hit ? current.tets.labelOf(hit.faceIndex) : '';
      return;
    }
    const hits = caster.intersectObjects(current.surfaces);
    if (hits.length > 0) {
      pick(hits[0].point);
    } else if (current.description.flat) {
      pick(caster.ray.origin.clone().setZ(0));
    }
  }

  function showLegend() {
    const legend = element('legend');
    legend.textContent = '';
    for (const item of current.items) {
      const row = make('label', legend);
      const box = make('input', row);
      box.type = 'checkbox';
      box.checked = item.object.visible;
      box.onchange = () => {
        item.object.visible = box.checked;
        draw();
      };
      const swatch = make('span', row);
      swatch.className = 'swatch';
      swatch.style.background = item.colour;
      make('span', row, item.name);
    }
    if (current.surfaces.length === 0) return;
    make('div', legend, 'opacity');
    const opacity = make('input', legend);
    Object.assign(opacity, { type: 'range', min: 0, max: 1, step: 0.05 });
    opacity.value = current.surfaces[0].material.opacity;
    opacity.oninput = () => {
      for (const surface of current.surfaces) surface.setOpacity(Number(opacity.value));
      draw();
    };
    const row = make('label', legend);
    const box = make('input', row);
    box.type = 'checkbox';
    box.checked = current.surfaces[0].children[0].visible;
    box.onchange = () => {
      for (const surface of current.surfaces) surface.children[0].visible = box.checked;
      draw();
    };
    make('span', row, 'triangles');
  }

  let player = null;

  function stopPlayer() {
    clearInterval(player);
    player = null;
  }

  // Plays all times once, from the first one when the last one is shown.
  function addPlayButton(holder, slider) {
    const button = make('button', holder, 'play');
    button.onclick = () => {
      if (player !== null) {
        stopPlayer();
        button.textContent = 'play';
        return;
      }
      if (Number(slider.value) === current.times.length - 1) slider.value = 0;
      button.textContent = 'stop';
      player = setInterval(() => {
        slider.value = Number(slider.value) + 1;
        slider.oninput();
        if (Number(slider.value) < current.times.length - 1) return;
        stopPlayer();
        button.textContent = 'play';
      }, 100);
    };
  }

  function showSlider() {
    const holder = element('time');
    stopPlayer();
    holder.textContent = '';
    if (current.times.length === 0) return;
    const text = make('label', holder);
    const slider = make('input', holder);
    Object.assign(slider, { type: 'range', min: 0, max: current.times.length - 1, step: 1 });
    slider.value = current.index === undefined ? current.times.length - 1 : current.index;
    slider.setAttribute('aria-label', scene.timeName);
    slider.oninput = () => {
      current.index = Number(slider.value);
      text.textContent = `${scene.timeName} ${Number(current.times[current.index].toPrecision(6))}`;
      setTime(current.times[current.index]);
    };
    slider.oninput();
    if (current.times.length > 1) addPlayButton(holder, slider);
  }

  function addSlider(holder, value, describe, take) {
    const text = make('label', holder, describe(value));
    const slider = make('input', holder);
    Object.assign(slider, { type: 'range', min: 0, max: 1, step: 0.005 });
    slider.value = value;
    slider.oninput = () => {
      take(Number(slider.value));
      text.textContent = describe(Number(slider.value));
      slider.setAttribute('aria-label', text.textContent);
      cutOpen();
    };
    slider.setAttribute('aria-label', text.textContent);
  }

  function cutOpen() {
    current.tets.cutOpen();
    draw();
  }

  // How the tetrahedra are cut open, and the scale of their colours.
  function showCut() {
    const holder = element('cut');
    holder.textContent = '';
    if (!current.tets) return;
    const item = current.description.tets;
    const number = value => Number(value.toPrecision(3));
    const row = make('label', holder, 'cut across');
    const axes = make('select', row);
    for (const name of ['x', 'y', 'z']) make('option', axes, name);
    axes.selectedIndex = cut.axis;
    axes.onchange = () => {
      cut.axis = axes.selectedIndex;
      cutOpen();
    };
    addSlider(holder, cut.position, value => `cut away ${Math.round(100 * value)} %`, value => { cut.position = value; });
    addSlider(holder, cut.limit,
              value => value < 1 ? `${item.valueName} up to ${number(item.worst + value * (item.best - item.worst))}`
                                 : `any ${item.valueName}`,
              value => { cut.limit = value; });
    const scale = make('div', holder);
    scale.className = 'scale';
    scale.style.background = scaleGradient;
    for (const value of [item.worst, item.best]) make('span', scale, number(value));
    cutOpen();
  }

  // The view is seen from where the one before it was seen from.
  function followCamera(view, previous) {
    view.camera.position.copy(previous.camera.position);
    view.camera.zoom = previous.camera.zoom;
    view.controls.target.copy(previous.controls.target);
    view.controls.update();
  }

  function show(index) {
    const previous = current;
    if (previous) previous.controls.enabled = false;
    current = views[index];
    if (scene.sharesCamera && previous) followCamera(current, previous);
    current.controls.enabled = true;
    Array.from(element('views').children).forEach((button, i) => button.setAttribute('aria-pressed', i === index));
    element('picked').textContent = '';
    element('help').textContent = (current.description.flat ? 'Drag to move, wheel to zoom.'
      : 'Drag to turn, wheel to zoom, right button to move.') +
      (current.description.fan ? ` Click to show: ${current.description.fan.name}.` : '') +
      (current.tets ? ` Click a cell to see its ${current.description.tets.valueName}.` : '');
    showLegend();
    showSlider();
    showCut();
    draw();
  }

  const views = scene.views.map(buildView);
  if (views.length === 0) return;
  if (views.length > 1) {
    views.forEach((view, index) => {
      make('button', element('views'), view.description.name).onclick = () => show(index);
    });
  }

  let pressed = null;
  canvas.addEventListener('pointerdown', event => { pressed = [event.offsetX, event.offsetY]; });
  canvas.addEventListener('pointerup', event => {
    if (event.button !== 0 || !pressed) return;
    if (Math.hypot(event.offsetX - pressed[0], event.offsetY - pressed[1]) < 5) click(event.offsetX, event.offsetY);
  });
  window.addEventListener('resize', resize);

  show(0);
  resize();
  window.dscView = { scene, show, setTime, pick, click, draw, camera: () => current.camera };
})();
