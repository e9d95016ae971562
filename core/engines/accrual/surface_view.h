#pragma once

namespace noonmark {

/// The data that a step's lookup of a surface needs besides the points and the map.
struct SurfaceView {
    float shearX, shearY;
    float column[3], row[3], q[3];  ///< rows of texelFromPlane
    float perQ[3];                  ///< 1 / q of a texel's centre, from (column, row, 1)
    float sun[3];                   ///< in the frame's axes
    float biasM;
    float slopeM;  ///< slope bias x metres per texel at q = 1 x sun[2]
    int columns, rows;
    int stride;
};

}  // namespace noonmark
