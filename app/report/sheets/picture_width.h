#pragma once

namespace noonmark {

/// Width of a picture, pixels: usual, and the range. Without Qt, for options.
constexpr int pictureWidth = 1600, leastPictureWidth = 400, mostPictureWidth = 12000;

}  // namespace noonmark
