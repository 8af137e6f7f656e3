// What the page shows now: the scene with all that follows from it, the moment, the step of the
// merge, what is selected, and the scenes before the last changes.

import { difference, isZero, separation } from "../exact/geometry.js";
import { isLess, momentOf, standingDifference, stateAt, toNumber } from "../exact/contact.js";
import { judge } from "../exact/reason.js";

export const POSITIONS = 1000; // of the slider
const UNDO_MAX = 100;
const NEAREST_OF_MAX = 20; // so many obstacles are compared to show the one with the least gap

export class Session {
  /** changed: called after every change; the argument tells whether the scene is another. */
  constructor(scene, changed) {
    this.changed = changed;
    this.open(scene);
  }

  /** Show a scene afresh. */
  open(scene) {
    this.history = [];
    this.selected = null;
    this.choice = null; // the obstacle that the user chose to see
    this.chosenStep = null; // of the merge: complete
    this.moment = momentOf(0, POSITIONS);
    this.set(scene);
  }

  /** Change the scene. undoable: the scene before can be had back. */
  edit(scene, undoable = true) {
    if (undoable) this.remember();
    this.set(scene);
  }

  remember() {
    this.history.push(this.scene);
    if (this.history.length > UNDO_MAX) this.history.shift();
  }

  undo() {
    const scene = this.history.pop();
    if (!scene) return;
    this.selected = null;
    this.set(scene);
  }

  set(scene) {
    this.scene = scene;
    this.verdict = judge(scene);
    if (this.choice !== null && this.choice >= scene.obstacles.length) this.choice = null;
    this.show();
    this.follow();
    this.changed(true);
  }

  choose(obstacle) {
    this.choice = obstacle;
    this.chosenStep = null;
    this.show();
    this.changed(false);
  }

  /** Work out what belongs to the obstacle that is shown; without one, all is null. */
  show() {
    const { scene, verdict } = this;
    this.shown = this.choice ?? verdict.first?.index ?? this.nearest();
    const obstacle = scene.obstacles[this.shown];
    this.sum = obstacle ? difference(obstacle, verdict.covered) : null;
    this.standing = obstacle ? standingDifference(obstacle, scene.robot) : null;
    this.place = obstacle ? verdict.places[this.shown] : null;
    this.line = this.place === "outside" ? separation(this.sum) : null;
  }

  /** The obstacle whose separating line has the least gap. It is only a choice of what to show. */
  nearest() {
    const { obstacles } = this.scene;
    if (obstacles.length > NEAREST_OF_MAX) return 0;
    const gaps = obstacles.map((obstacle) => {
      const line = separation(difference(obstacle, this.verdict.covered));
      return line ? Number(line.gap) / Math.hypot(...line.along) : 0;
    });
    return gaps.indexOf(Math.min(...gaps));
  }

  goTo(moment) {
    this.moment = moment;
    this.follow();
    this.changed(false);
  }

  get position() {
    return Math.round(toNumber(this.moment) * POSITIONS);
  }

  /** Which obstacles the robot touches at the moment. */
  follow() {
    const { scene, moment } = this;
    const { places, first } = this.verdict;
    const isBefore = first === null || isLess(moment, first.moment);
    this.touches = scene.obstacles.map((obstacle, index) => {
      if (isBefore || places[index] === "outside") return false;
      return isZero(scene.move) || stateAt(scene, obstacle, moment) !== "outside";
    });
  }

  get steps() {
    return this.sum?.steps.length ?? 0;
  }

  /** The step of the merge; a merge that is complete stays so when the scene changes. */
  get step() {
    return Math.min(this.chosenStep ?? this.steps, this.steps);
  }

  goToStep(step) {
    this.chosenStep = step >= this.steps ? null : Math.max(step, 0);
    this.changed(false);
  }

  select(part) {
    this.selected = part;
    if (part?.kind === "obstacle" && part.index !== this.shown) this.choose(part.index);
    else this.changed(false);
  }
}
