// Flies the pieces in a file, as they lie in the memory of a Crazyflie, by its firmware: for each time (s) on standard input, position,
// velocity and yaw.
#include <stdio.h>
#include "pptraj.h"

int main(int count, char **arguments) {
  static struct poly4d pieces[31];
  FILE *memory = fopen(arguments[1], "rb");
  struct piecewise_traj plan = {.timescale = 1, .pieces = pieces};
  plan.n_pieces = fread(pieces, sizeof(struct poly4d), 31, memory);
  double time;
  while (scanf("%lf", &time) == 1) {
    struct traj_eval at = piecewise_eval(&plan, time);
    printf("%.9g %.9g %.9g %.9g %.9g %.9g %.9g\n", at.pos.x, at.pos.y, at.pos.z, at.vel.x, at.vel.y, at.vel.z, at.yaw);
  }
  return 0;
}
