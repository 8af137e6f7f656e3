// What part of the plane a board shows: all of its scene, or only the place that decides.

import { differenceBox } from "./difference_view.js";
import { marginOf, nearPlace, sceneBox } from "./scene_view.js";

const FINE_PX = 2; // units, and gaps, that are smaller cannot be seen

const wholeOf = {
  scene: ({ scene }) => sceneBox(scene),
  difference: ({ scene, sum }) => (sum ? differenceBox(sum) : sceneBox(scene)),
};

/** The box around the place that decides; null if there is none. */
const nearOf = {
  scene: (session) => around(nearPlace(session)),
  difference: (session) => around(nearPlace(session) && [[0, 0], nearPlace(session)[1]]),
};

function around(place) {
  if (!place) return null;
  const [[x, y], room] = place;
  return [x - room, y - room, x + room, y + room];
}

/** The sight of one board. name: scene or difference. note: shown while the board hides a part. */
export class Sight {
  constructor(name, board, note) {
    this.board = board;
    this.note = note;
    this.wholeOf = wholeOf[name];
    this.nearOf = nearOf[name];
  }

  /** Show another scene: all of it, unless what decides is too small to be seen there. */
  open(session) {
    const unit = this.board.view.scaleFor(this.wholeOf(session));
    const isFine = session.sum && unit < FINE_PX && marginOf(session.sum) * unit < FINE_PX;
    if (!isFine || !this.showNear(session)) this.showWhole(session);
  }

  showWhole(session) {
    this.board.fit(this.wholeOf(session), true);
    this.board.redraw();
  }

  /** Show the place that decides, and stay there; false if there is none. */
  showNear(session) {
    const box = this.nearOf(session);
    if (!box) return false;
    this.board.fit(box, true);
    this.board.isOwnView = true;
    this.board.redraw();
    return true;
  }

  /** Before each drawing: follow a scene that grew or shrank, unless the user chose the view. */
  follow(session) {
    const whole = this.wholeOf(session);
    if (!this.board.drag) this.board.fit(whole);
    this.note.hidden = this.board.view.holds(whole);
  }
}
