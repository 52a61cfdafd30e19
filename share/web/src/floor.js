// The floor plan as a picture on the ground: cells of the reference's grid, two bits each.
import * as THREE from 'three';
import { FREE, OCCUPIED, cellsOf } from './store.js';
import { FLOOR, WALL, colourOf } from './look.js';

export class Floor {
  constructor(floor) {
    this.floor = floor;
    this.cells = cellsOf(floor);
    this.canvas = document.createElement('canvas');
    this.canvas.width = floor.width;
    this.canvas.height = floor.height;
    this.texture = new THREE.CanvasTexture(this.canvas);
    this.texture.colorSpace = THREE.SRGBColorSpace;
    this.texture.magFilter = THREE.NearestFilter;
    const width = floor.width * floor.resolution;
    const height = floor.height * floor.resolution;
    this.object = new THREE.Mesh(new THREE.PlaneGeometry(width, height), new THREE.MeshBasicMaterial({ map: this.texture, transparent: true }));
    this.object.position.set(floor.origin[0] + width / 2, floor.origin[1] + height / 2, -0.01);
    this.object.renderOrder = -1; // what lies on it is drawn over it
    this.paint();
  }

  /** In the colours of the theme. */
  paint() {
    const pen = this.canvas.getContext('2d');
    const { width, height } = this.floor;
    pen.clearRect(0, 0, width, height);
    const colours = { [FREE]: colourOf(FLOOR), [OCCUPIED]: colourOf(WALL) };
    for (let y = 0; y < height; ++y) {
      for (let x = 0; x < width; ++x) {
        const colour = colours[this.cells[y * width + x]];
        if (!colour) continue;
        pen.fillStyle = colour;
        pen.fillRect(x, height - 1 - y, 1, 1);
      }
    }
    this.texture.needsUpdate = true;
  }

  /** Corners of what is known [m]: [west, south, east, north]. */
  bounds() {
    const { width, resolution, origin } = this.floor;
    const known = [Infinity, Infinity, -Infinity, -Infinity];
    this.cells.forEach((cell, i) => {
      if (cell === 0) return;
      const x = origin[0] + ((i % width) + 0.5) * resolution;
      const y = origin[1] + (Math.floor(i / width) + 0.5) * resolution;
      known[0] = Math.min(known[0], x);
      known[1] = Math.min(known[1], y);
      known[2] = Math.max(known[2], x);
      known[3] = Math.max(known[3], y);
    });
    return known[0] <= known[2] ? known : [-1, -1, 1, 1];
  }
}
