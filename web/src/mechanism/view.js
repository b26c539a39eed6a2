// The mechanism drawn by three.js. Nothing moves by itself: a picture is drawn when something changed.
import {
  BufferAttribute, BufferGeometry, Color, DirectionalLight, Group, HemisphereLight, InstancedMesh,
  Matrix4, Mesh, MeshBasicMaterial, MeshLambertMaterial, PerspectiveCamera, Quaternion, Raycaster, Scene,
  DataTexture, InstancedBufferAttribute, Matrix3, ShapeUtils, SphereGeometry, Vector2, Vector3, Vector4, WebGLRenderer,
  BackSide,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

import {
  azimuth, contactPlace, contactShift, nutLine, nutSection, revolvedMesh, rollerLines, rollerTurn, screwLines, screwTooth, threadAt,
  threadMesh,
} from './geometry.js';
import { sides } from './numbers.js';

const degree = Math.PI / 180;
/** The nut is left out between these azimuths, where the picture is first looked at from. */
const cut = { from: -25 * degree, to: 115 * degree };
/** Segments of a turn, and those where software draws or pictures take long. */
const segments = { roller: [28, 8], body: [96, 36], contact: [[6, 4], [4, 2]] };
/** Share of the pixels across while a coarse view turns. */
const turning = 0.6;
/** Milliseconds of a picture while the view turns, above which it is drawn coarser. */
const slow = 40;

function geometryOf({ positions, normals, index }) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new BufferAttribute(normals, 3));
  geometry.setIndex(new BufferAttribute(index, 1));
  return geometry;
}

/** Several of them as one. */
function joined(meshes) {
  const whole = { positions: [], normals: [], index: [] };
  for (const key of ['positions', 'normals']) {
    whole[key] = new Float32Array(meshes.reduce((n, mesh) => n + mesh[key].length, 0));
    meshes.reduce((at, mesh) => (whole[key].set(mesh[key], at), at + mesh[key].length), 0);
  }
  whole.index = new Uint32Array(meshes.reduce((n, mesh) => n + mesh.index.length, 0));
  let at = 0;
  let vertices = 0;
  for (const mesh of meshes) {
    for (const k of mesh.index) whole.index[at++] = k + vertices;
    vertices += mesh.positions.length / 3;
  }
  return whole;
}

/** A geometry as often as asked, with colours; `put` gives each its place. */
function repeated(geometry, times) {
  const vertices = geometry.attributes.position.count;
  const { array: index } = geometry.index;
  const all = new BufferGeometry();
  for (const name of ['position', 'normal', 'color']) all.setAttribute(name, new BufferAttribute(new Float32Array(3 * vertices * times), 3));
  all.setIndex(new BufferAttribute(Uint32Array.from({ length: index.length * times }, (_, k) => index[k % index.length] + vertices * Math.floor(k / index.length)), 1));
  return all;
}

function put(all, geometry, at, matrix, colour) {
  const normals = new Matrix3().getNormalMatrix(matrix);
  const point = new Vector3();
  const { count } = geometry.attributes.position;
  for (let k = 0; k < count; k++) {
    const to = at * count + k;
    point.fromBufferAttribute(geometry.attributes.position, k).applyMatrix4(matrix);
    all.attributes.position.setXYZ(to, point.x, point.y, point.z);
    point.fromBufferAttribute(geometry.attributes.normal, k).applyNormalMatrix(normals);
    all.attributes.normal.setXYZ(to, point.x, point.y, point.z);
    all.attributes.color.setXYZ(to, colour.r, colour.g, colour.b);
  }
  for (const attribute of Object.values(all.attributes)) attribute.needsUpdate = true;
}

/** The flat faces where the nut is cut. */
function nutFace(d, phi, outwards) {
  const outline = nutSection(d, phi);
  const triangles = ShapeUtils.triangulateShape(outline.map(([x, r]) => new Vector2(x, r)), []);
  return {
    positions: new Float32Array(outline.flatMap(([x, r]) => [x, r * Math.cos(phi), r * Math.sin(phi)])),
    normals: new Float32Array(outline.flatMap(() => [0, -outwards * Math.sin(phi), outwards * Math.cos(phi)])),
    index: new Uint32Array(triangles.flatMap((corners) => (outwards > 0 ? corners : corners.reverse()))),
  };
}

/**
 * Rollers whose threads have the colours of their contacts where they touch screw and nut, fading
 * out between: from a texture with a column per thread, and two rows per roller, screw and nut.
 */
function rollerMaterial(colour, uniforms) {
  const material = new MeshLambertMaterial({ color: colour });
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms);
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', `#include <common>
        attribute vec2 shift;
        uniform sampler2D colours;
        uniform vec4 threads; // First thread, pitch, number, root.
        varying vec4 vContact;`)
      .replace('#include <begin_vertex>', `#include <begin_vertex>
        vec2 arm = (mat3(instanceMatrix) * vec3(0.0, position.yz)).yz;
        float towards = dot(arm, normalize(instanceMatrix[3].yz)) / max(length(arm), 1e-6);
        bool atNut = towards > 0.0;
        float thread = floor((position.x - threads.x - (atNut ? shift.y : shift.x)) / threads.y + 0.5);
        vContact = vec4(0.0);
        if (thread >= 0.0 && thread < threads.z && length(arm) > 0.999 * threads.w) {
          vContact = texelFetch(colours, ivec2(int(thread), 2 * gl_InstanceID + int(atNut)), 0);
          vContact.a *= smoothstep(0.1, 0.9, abs(towards));
        }`);
    shader.fragmentShader = shader.fragmentShader
      .replace('#include <common>', '#include <common>\nvarying vec4 vContact;')
      .replace('#include <color_fragment>', `#include <color_fragment>
        diffuseColor.rgb = mix(diffuseColor.rgb, vContact.rgb, vContact.a);`);
  };
  return material;
}

export class View {
  /** `theme` gives colours: of parts, the `scale` of numbers, `quiet` of what has none, `chosen`. */
  constructor(canvas, context, { isFast, onPick, theme }) {
    this.canvas = canvas;
    this.theme = theme;
    this.onPick = onPick;
    this.renderer = new WebGLRenderer({ canvas, context });
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(28, 2, 1, 1e4);
    this.lights = new Group();
    const sky = new HemisphereLight(0xffffff, 0xa9aeb4, 1.9);
    const sun = new DirectionalLight(0xffffff, 1.9);
    sun.position.set(-0.4, 1, 0.8);
    this.lights.add(sky, sun);
    this.camera.add(sun);
    this.scene.add(sky, this.camera);
    this.uniforms = { colours: { value: null }, threads: { value: new Vector4() } };
    this.materials = {
      screw: new MeshLambertMaterial({ color: theme.screw }),
      rollers: rollerMaterial(theme.rollers, this.uniforms),
      nut: new MeshLambertMaterial({ color: theme.nut }),
      contacts: new MeshLambertMaterial({ vertexColors: true, emissive: 0x333333 }),
      chosen: new MeshBasicMaterial({ color: theme.chosen, side: BackSide }),
    };
    this.level = isFast ? 0 : 1;
    this.times = [];
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.enableZoom = false;
    canvas.style.touchAction = 'pan-y'; // A finger that moves along the page scrolls it.
    this.controls.addEventListener('change', () => this.move());
    this.listeners = new AbortController();
    const { signal } = this.listeners;
    const on = (name, act, options = {}) => canvas.addEventListener(name, act, { signal, ...options });
    on('pointerdown', (event) => (this.pressed = [event.clientX, event.clientY]));
    on('pointerup', (event) => this.click(event));
    on('focus', () => (this.controls.enableZoom = true));
    on('blur', () => (this.controls.enableZoom = false));
    on('webglcontextlost', (event) => event.preventDefault());
    on('webglcontextrestored', () => this.draw());
    this.sizes = new ResizeObserver(() => this.resize());
    this.sizes.observe(canvas);
  }

  /** Draws the mechanism anew where its sizes are others. */
  show(d) {
    const same = JSON.stringify({ ...d, missing: [...d.missing] });
    if (same === this.same) return;
    const isFirst = this.same === undefined;
    this.same = same;
    this.d = d;
    this.build();
    if (isFirst) this.home();
    this.resize();
  }

  build() {
    const { d, level } = this;
    if (this.bodies) {
      this.scene.remove(this.bodies);
      this.bodies.traverse((object) => object.geometry?.dispose());
      for (const object of [this.rollers, this.chosen]) object.dispose();
    }
    this.bodies = new Group();
    const narrow = level ? 0.1 : undefined;
    const around = { segments: segments.body[level], narrow };
    const open = { start: cut.to, end: cut.from + 2 * Math.PI, segments: Math.round((around.segments * 220) / 360), narrow };
    const screw = new Mesh(geometryOf(joined([
      threadMesh(d.screw, { tooth: screwTooth(d), from: d.screw.from, to: d.screw.to, ...around }),
      ...screwLines(d).map((line) => revolvedMesh(line, around)),
    ])), this.materials.screw);
    const nut = new Mesh(geometryOf(joined([
      threadMesh(d.nut, { tooth: d.first, from: 0, to: d.nut.length, inward: true, ...open }),
      revolvedMesh(nutLine(d), open),
      nutFace(d, open.start, -1),
      nutFace(d, open.end, 1),
    ])), this.materials.nut);
    const ofRoller = { segments: segments.roller[level], narrow };
    const roller = geometryOf(joined([
      threadMesh(d.roller, { tooth: d.first, from: d.roller.from, to: d.roller.to, ...ofRoller }),
      ...rollerLines(d).map((line) => revolvedMesh(line, ofRoller)),
    ]));
    this.places = Array.from({ length: d.rollers }, (_, k) => k).filter((k) => !d.missing.has(k + 1));
    this.rollers = new InstancedMesh(roller, this.materials.rollers, this.places.length);
    this.places.forEach((k, at) => {
      const phi = azimuth(d, k);
      const matrix = new Matrix4().makeRotationX(rollerTurn(d, k));
      matrix.setPosition(0, d.centreDistance * Math.cos(phi), d.centreDistance * Math.sin(phi));
      this.rollers.setMatrixAt(at, matrix);
    });
    const shifts = this.places.flatMap((k) => sides.map((side) => contactShift(d, side, k)));
    roller.setAttribute('shift', new InstancedBufferAttribute(new Float32Array(shifts), 2));
    this.uniforms.threads.value.set(d.first, d.pitch, d.contacts, d.roller.low);
    this.uniforms.colours.value?.dispose();
    this.uniforms.colours.value = new DataTexture(new Uint8Array(8 * d.contacts * this.places.length), d.contacts, 2 * this.places.length);
    // One mesh of all contacts: where software draws, instances take longer than their triangles.
    this.drop = new SphereGeometry(1, ...segments.contact[level]);
    this.contacts = new Mesh(repeated(this.drop, 2 * this.places.length * d.contacts), this.materials.contacts);
    this.chosen = new InstancedMesh(this.drop, this.materials.chosen, 2 * this.places.length);
    this.chosen.count = 0;
    this.parts = { screw, rollers: this.rollers, nut };
    for (const [part, mesh] of Object.entries(this.parts)) mesh.visible = !this.hidden?.has(part);
    this.bodies.add(screw, nut, this.rollers, this.contacts, this.chosen);
    this.scene.add(this.bodies);
    this.paint();
  }

  /**
   * Colours: `contacts(side, roller, thread)` is a share of the scale or null, `parts` shares of the
   * parts or null.
   */
  colour(colours) {
    this.colours = colours;
    this.paint();
    this.draw();
  }

  paint() {
    if (!this.colours || !this.contacts) return;
    const { d } = this;
    const colour = new Color();
    const none = new Color(this.theme.quiet);
    const { image: { data: texture } } = this.uniforms.colours.value;
    let at = 0;
    for (const roller of this.places)
      for (const side of sides)
        for (let thread = 0; thread < d.contacts; thread++, at++) {
          const share = this.colours.contacts(side, roller, thread);
          const shown = share === null ? none : this.scale(share, colour);
          texture.set([shown.r, shown.g, shown.b, share === null ? 0 : 0.8].map((part) => Math.round(255 * part)), 4 * at);
          put(this.contacts.geometry, this.drop, at, this.patch(side, roller, thread, share), shown);
        }
    this.uniforms.colours.value.needsUpdate = true;
    this.contacts.geometry.computeBoundingSphere();
    for (const part of Object.keys(this.parts)) {
      const share = this.colours.parts?.[part];
      this.materials[part].color = share === undefined ? new Color(this.theme[part]) : this.scale(share, new Color());
    }
    this.choose(this.picked);
  }

  scale(share, colour) {
    const { scale } = this.theme;
    const at = Math.max(0, Math.min(1, share)) * (scale.length - 1);
    const k = Math.min(scale.length - 2, Math.floor(at));
    return colour.set(scale[k]).lerp(new Color(scale[k + 1]), at - k);
  }

  /** A contact as a flat drop on its flank, larger under a larger load. */
  patch(side, roller, thread, share, more = 1) {
    const { d } = this;
    const { x, phi, radius, along } = contactPlace(d, side, roller, thread);
    const size = more * d.pitch * (0.2 + 0.22 * Math.cbrt(Math.max(0, share ?? 0)));
    const outwards = new Vector3(0, Math.cos(phi), Math.sin(phi));
    const flank = new Vector3(along[0], along[1] * outwards.y, along[1] * outwards.z);
    const around = new Vector3(0, -outwards.z, outwards.y);
    const across = new Vector3().crossVectors(flank, around);
    const matrix = new Matrix4().makeBasis(flank.multiplyScalar(size), around.multiplyScalar(1.25 * size), across.multiplyScalar(0.45 * size));
    return matrix.setPosition(x, radius * outwards.y, radius * outwards.z);
  }

  /** A thread of a roller, both from 0, or of all rollers where `roller` is null; null: none. */
  choose(picked) {
    this.picked = picked;
    if (!this.chosen) return;
    let at = 0;
    if (picked)
      for (const roller of picked.roller === null ? this.places : [picked.roller])
        for (const side of sides)
          this.chosen.setMatrixAt(at++, this.patch(side, roller, picked.thread, this.colours?.contacts(side, roller, picked.thread), 1.9));
    this.chosen.count = at;
    this.chosen.instanceMatrix.needsUpdate = true;
    this.draw();
  }

  /** Shows or hides `screw`, `rollers` or `nut`. */
  setVisible(part, visible) {
    this.hidden ??= new Set();
    this.hidden[visible ? 'delete' : 'add'](part);
    this.parts[part].visible = visible;
    this.draw();
  }

  home() {
    const { d } = this;
    const middle = (Math.min(0, d.screw.from) + Math.max(d.nut.length, d.screw.to)) / 2;
    this.controls.target.set(middle, 0, 0);
    const towards = new Vector3(-0.5, 0.55, 0.95).normalize();
    this.camera.position.copy(towards).multiplyScalar(this.distance(towards)).add(this.controls.target);
    this.controls.update();
  }

  /** From the middle to where the whole mechanism is seen in that direction. */
  distance(towards) {
    const { d, camera } = this;
    const right = new Vector3().crossVectors(camera.up, towards).normalize();
    const up = new Vector3().crossVectors(towards, right);
    const half = 0.96 * Math.tan((camera.fov / 2) * degree);
    const ends = [[d.screw.from, d.screw.high], [d.screw.to, d.screw.high], ...d.nut.outer.flatMap(([from, to, r]) => [[from, r], [to, r]])];
    let distance = 0;
    for (const [x, r] of ends)
      for (let k = 0; k < 16; k++) {
        const point = new Vector3(x, r * Math.cos((k * Math.PI) / 8), r * Math.sin((k * Math.PI) / 8)).sub(this.controls.target);
        const across = Math.max(Math.abs(point.dot(right)) / camera.aspect, Math.abs(point.dot(up)));
        distance = Math.max(distance, point.dot(towards) + across / half);
      }
    return distance;
  }

  turn(across, up) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const right = new Vector3().setFromMatrixColumn(this.camera.matrix, 0);
    offset.applyQuaternion(new Quaternion().setFromAxisAngle(this.camera.up, across));
    if (Math.abs(offset.angleTo(this.camera.up) - Math.PI / 2 + up) < 1.5) offset.applyQuaternion(new Quaternion().setFromAxisAngle(right, up));
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
  }

  zoom(factor) {
    this.camera.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
    this.controls.update();
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas;
    if (!clientWidth || !clientHeight || !this.d) return;
    const before = this.camera.aspect;
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.near = 0.5;
    this.camera.far = 100 * (this.d.screw.to - this.d.screw.from);
    this.camera.updateProjectionMatrix();
    this.setSharpness(1);
    if (Math.abs(before - this.camera.aspect) > 0.01) this.home();
    else this.draw();
  }

  /** Pixels of the picture over those of the screen. */
  setSharpness(share) {
    const ratio = share * (this.level ? 1 : Math.min(2, globalThis.devicePixelRatio));
    const { clientWidth, clientHeight } = this.canvas;
    const isSame = this.renderer.getPixelRatio() === ratio && this.canvas.width === Math.floor(ratio * clientWidth);
    if (isSame && this.canvas.height === Math.floor(ratio * clientHeight)) return;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(clientWidth, clientHeight, false);
  }

  /** A picture of a movement: coarse, where pictures take long, until the view rests. */
  move() {
    if (this.level) {
      this.setSharpness(turning);
      this.contacts.visible = !this.rollers.visible; // Rollers show the colours, too.
      clearTimeout(this.resting);
      this.resting = setTimeout(() => {
        this.setSharpness(1);
        this.contacts.visible = true;
        this.draw();
      }, 250);
    }
    this.draw();
  }

  draw() {
    if (this.isWaiting || !this.bodies) return;
    this.isWaiting = true;
    requestAnimationFrame((now) => {
      this.isWaiting = false;
      this.watch(now);
      this.renderer.render(this.scene, this.camera);
    });
  }

  /** Draws coarser where several pictures in a row took long. */
  watch(now) {
    const since = now - (this.last ?? -Infinity);
    this.last = now;
    if (since > 500) this.times = [];
    else this.times.push(since);
    if (this.level || this.times.length < 6) return;
    const mean = this.times.reduce((sum, time) => sum + time, 0) / this.times.length;
    this.times = [];
    if (mean < slow) return;
    this.level = 1;
    this.build();
    this.resize();
  }

  click(event) {
    const [x, y] = this.pressed ?? [];
    if (!(Math.hypot(event.clientX - x, event.clientY - y) < 5)) return;
    const box = this.canvas.getBoundingClientRect();
    const at = new Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2);
    const picked = this.threadUnder(at);
    if (picked) this.onPick(picked);
  }

  threadUnder(at) {
    const { d } = this;
    const ray = new Raycaster();
    ray.setFromCamera(at, this.camera);
    const shown = [this.contacts, ...Object.values(this.parts).filter((part) => part.visible)];
    const [hit] = ray.intersectObjects(shown, false);
    if (!hit) return null;
    if (hit.object === this.contacts) {
      const at = Math.floor((3 * hit.faceIndex) / this.drop.index.count);
      return { roller: this.places[Math.floor(at / (2 * d.contacts))], thread: at % d.contacts };
    }
    if (hit.object === this.rollers) return { roller: this.places[hit.instanceId], thread: threadAt(d, hit.point.x) };
    return null;
  }

  dispose() {
    this.listeners.abort();
    clearTimeout(this.resting);
    this.sizes.disconnect();
    this.controls.dispose();
    this.bodies?.traverse((object) => object.geometry?.dispose());
    this.uniforms.colours.value?.dispose();
    for (const material of Object.values(this.materials)) material.dispose();
    this.renderer.dispose();
  }
}
