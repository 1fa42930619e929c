// Prints what mav_trajectory_generation reads from a file: the time (ns) and the coefficients of each segment on a line.
#include <iomanip>
#include <iostream>
#include "mav_trajectory_generation/io.h"

int main(int, char** arguments) {
  mav_trajectory_generation::Trajectory trajectory;
  if (!mav_trajectory_generation::trajectoryFromFile(arguments[1], &trajectory)) return 1;
  mav_trajectory_generation::Segment::Vector segments;
  trajectory.getSegments(&segments);
  std::cout << std::setprecision(17);
  for (const auto& segment : segments) {
    std::cout << segment.getTimeNSec();
    for (int axis = 0; axis < segment.D(); ++axis) {
      // The value and derivatives at 0 are the coefficients times factorials.
      double factorial = 1;
      for (int order = 0; order < segment.N(); ++order) {
        if (order > 0) factorial *= order;
        std::cout << ' ' << segment.evaluate(0.0, order)(axis) / factorial;
      }
    }
    std::cout << '\n';
  }
}
