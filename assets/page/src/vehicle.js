// The vehicle in space: its arms and rotors as the spec has them, those that a fault takes marked. It is drawn larger than it is
// where it would be too small to see.

import { BufferGeometry, CircleGeometry, CylinderGeometry, DoubleSide, Group, Line, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, TorusGeometry, Vector3 } from "three";
import { content } from "./content.js";
import { css } from "./palette.js";

/** Distance of the outermost rotor from the middle, as a share of the scene, at least. */
const LEAST = 0.05;

/** The vehicle of a scene of the given size. `mark` takes the indices of affected rotors, each with whether it is lost. */
export function vehicle(size) {
  const rotors = content.rotors.map((at) => new Vector3(...at));
  const reach = Math.max(...rotors.map((r) => r.length()), 1e-3);
  const scale = Math.max(1, (LEAST * size) / reach);
  const ink = new MeshBasicMaterial();
  const disc = new MeshBasicMaterial({ transparent: true, opacity: 0.3, side: DoubleSide, depthWrite: false });
  const gone = new MeshBasicMaterial();
  const weak = new MeshBasicMaterial();
  const crosses = new LineBasicMaterial();
  const mast = new LineBasicMaterial();
  const apart = (a, b) => Math.hypot(a.x - b.x, a.y - b.y);
  const gaps = rotors.flatMap((a, i) => rotors.slice(i + 1).map((b) => apart(a, b))).filter((d) => d > 1e-3 * reach);
  const radius = Math.min(0.46 * Math.min(...gaps, 2 * reach), 0.75 * reach);

  const made = new Group();
  made.rotation.order = "ZYX";
  made.scale.setScalar(scale);
  const rings = rotors.map((at) => {
    // Arms lie in the plane of the body; where rotors are one over the other they differ in height.
    const arm = new Mesh(new CylinderGeometry(0.025 * reach, 0.025 * reach, at.length(), 8), ink);
    arm.position.copy(at).multiplyScalar(0.5);
    arm.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), at.clone().normalize());
    const ring = new Mesh(new TorusGeometry(radius, 0.028 * reach, 8, 28), ink);
    const face = new Mesh(new CircleGeometry(radius, 28), disc);
    const half = 0.9 * radius;
    const across = [[-half, -half], [half, half], [-half, half], [half, -half]].map(([u, v]) => new Vector3(u, v, 0));
    const cross = new LineSegments(new BufferGeometry().setFromPoints(across), crosses);
    for (const part of [ring, face, cross]) part.position.copy(at);
    made.add(arm, ring, face, cross);
    return { ring, face, cross };
  });
  const nose = new Mesh(new CylinderGeometry(0.001 * reach, 0.07 * reach, 0.35 * reach, 10), ink);
  nose.rotation.z = -Math.PI / 2;
  nose.position.x = 0.35 * reach;
  const thrust = new Line(new BufferGeometry().setFromPoints([new Vector3(), new Vector3(0, 0, 1.3 * reach)]), mast);
  made.add(nose, thrust);
  return {
    made,
    /** How many times larger than the vehicle the picture of it is. */
    scale,
    mark(struck) {
      rings.forEach(({ ring, face, cross }, k) => {
        const found = struck.find(([rotor]) => rotor === k);
        ring.material = found ? (found[1] ? gone : weak) : ink;
        face.visible = !found?.[1];
        cross.visible = Boolean(found?.[1]);
      });
    },
    theme() {
      for (const m of [ink, disc, mast]) m.color.set(css("--ink"));
      for (const m of [gone, crosses]) m.color.set(css("--bad"));
      weak.color.set(css("--edge"));
    },
  };
}
