/** A stage in three dimensions, by three.js: lights, shadows, and a camera that circles until it is taken by hand. */
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

/** A colour of the page. @param {string} name */
export const colour = (name) =>
  new THREE.Color(getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim());

/**
 * @param {HTMLCanvasElement} canvas
 * @param {[number, number, number]} target  what the camera looks at
 * @param {[number, number, number]} from  where it is
 * @param {number} size  of the scene, metres
 */
export function makeStage(canvas, target, from, size) {
  const renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
  renderer.shadowMap.enabled = true;
  const scene = new THREE.Scene();
  const camera = new THREE.PerspectiveCamera(38, 1, size / 100, size * 20);
  camera.up.set(0, 0, 1);
  camera.position.set(...from);
  const controls = new OrbitControls(camera, canvas);
  controls.target.set(...target);
  controls.autoRotate = !matchMedia("(prefers-reduced-motion: reduce)").matches;
  controls.autoRotateSpeed = 0.5;
  const sun = new THREE.DirectionalLight(0xffffff, 2.2);
  sun.position.set(target[0] - size, target[1] - 0.6 * size, target[2] + 1.8 * size);
  sun.target.position.set(...target);
  sun.castShadow = true;
  sun.shadow.mapSize.set(1024, 1024);
  Object.assign(sun.shadow.camera, { left: -size, right: size, top: size, bottom: -size, near: 0.1, far: 6 * size });
  sun.shadow.bias = -0.0005;
  sun.shadow.normalBias = size / 500;
  scene.add(sun, sun.target, new THREE.HemisphereLight(0xffffff, 0x8088a0, 2));
  const paint = () => {
    scene.background = colour("page");
  };
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => location.reload());
  paint();
  const render = () => {
    const { clientWidth: width, clientHeight: height } = canvas;
    const ratio = Math.min(devicePixelRatio, 2);
    if (canvas.width !== Math.floor(width * ratio) || canvas.height !== Math.floor(height * ratio)) {
      renderer.setPixelRatio(ratio);
      renderer.setSize(width, height, false);
      camera.aspect = width / height;
      // On a narrow screen the whole width of the scene stays in view.
      camera.zoom = Math.min(1, camera.aspect / 1.2);
      camera.updateProjectionMatrix();
    }
    controls.update();
    renderer.render(scene, camera);
  };
  return { scene, render };
}

/**
 * Boxes of one colour, each by its least and greatest corner.
 * @param {number[][]} boxes
 * @param {string} name
 * @param {number} [opacity]
 */
export function makeBoxes(boxes, name, opacity = 1) {
  const material = new THREE.MeshStandardMaterial({
    color: colour(name),
    roughness: 0.9,
    transparent: opacity < 1,
    opacity,
  });
  const mesh = new THREE.InstancedMesh(new THREE.BoxGeometry(1, 1, 1), material, boxes.length);
  boxes.forEach(([ax, ay, az, bx, by, bz], i) => {
    const scale = new THREE.Matrix4().makeScale(bx - ax, by - ay, bz - az);
    mesh.setMatrixAt(i, scale.setPosition((ax + bx) / 2, (ay + by) / 2, (az + bz) / 2));
  });
  mesh.castShadow = mesh.receiveShadow = true;
  return mesh;
}

/** Segments, given by rows of x, y, z; they are replaced as they grow. @param {string} name @param {number} opacity */
export function makeSegments(name, opacity) {
  const lines = new THREE.LineSegments(
    new THREE.BufferGeometry(),
    new THREE.LineBasicMaterial({ color: colour(name), transparent: true, opacity }),
  );
  lines.frustumCulled = false;
  const set = (/** @type {number[]} */ points) => {
    lines.geometry.dispose();
    lines.geometry = new THREE.BufferGeometry().setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
  };
  return { lines, set };
}

/** A tube through points. @param {number[][]} points @param {number} radius @param {string} name */
export function makeTube(points, radius, name) {
  const curve = new THREE.CurvePath();
  const vectors = points.map((point) => new THREE.Vector3(...point));
  vectors.slice(1).forEach((vector, i) => curve.add(new THREE.LineCurve3(vectors[i], vector)));
  const tube = new THREE.TubeGeometry(/** @type {any} */ (curve), Math.min(600, 24 * points.length), radius, 10);
  const mesh = new THREE.Mesh(tube, new THREE.MeshStandardMaterial({ color: colour(name), roughness: 0.5 }));
  mesh.castShadow = true;
  return mesh;
}

/** Balls of one colour, placed again by rows of x, y, z and radius. @param {number} count @param {string} name */
export function makeBalls(count, name) {
  const mesh = new THREE.InstancedMesh(
    new THREE.SphereGeometry(1, 28, 20),
    new THREE.MeshStandardMaterial({ color: colour(name), roughness: 0.55 }),
    count,
  );
  mesh.castShadow = mesh.receiveShadow = true;
  mesh.frustumCulled = false;
  const matrix = new THREE.Matrix4();
  const set = (/** @type {ArrayLike<number>} */ rows) => {
    for (let i = 0; i < count; i += 1) {
      const radius = rows[4 * i + 3];
      mesh.setMatrixAt(
        i,
        matrix.makeScale(radius, radius, radius).setPosition(rows[4 * i], rows[4 * i + 1], rows[4 * i + 2]),
      );
    }
    mesh.instanceMatrix.needsUpdate = true;
  };
  return { mesh, set };
}
