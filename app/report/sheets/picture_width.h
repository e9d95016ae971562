#pragma once

namespace noonmark {

/// Width of a picture, pixels: default, and the range. Without Qt, for options.
constexpr int pictureWidth = 1600, minPictureWidth = 400, maxPictureWidth = 12000;

}  // namespace noonmark
