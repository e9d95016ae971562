#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/engines/ray/ray_scene.h"
#include "core/engines/ray/visible_surface.h"

namespace noonmark {

/// The rays of a block of 4 x 4 pixels, which one packet holds row by row from the top.
struct PixelBlock {
    static constexpr int sidePx = 4;
    glm::vec3 origin, direction;  ///< of the first pixel
    glm::vec3 right, down;        ///< added for each pixel further
    bool parallel = false;        ///< whether they are added to the origin instead of the direction
};

/// Directs the rays of a packet at the pixels of a block; its distances are left as they are.
void aimRays(const PixelBlock& block, HitPacket& packet);

/// Ends rays at the level plane `groundM` that reach it between `from` and `distance`. Bit k: ray k does.
std::uint32_t endAtGround(float groundM, HitPacket& packet);

/// The bits of each pixel (TracedPixel::bits) from the packet's hits. `ground`: see endAtGround(). `cut`:
/// surfaces that are seen from behind are cuts.
void packPixels(const HitPacket& packet, std::uint32_t ground, bool cut, std::uint32_t* bits);

/// Turns the rays of a packet with hits towards the sun (a unit vector), from the surface of each pixel, of
/// which `bits` has the normal. Pixels that face away from the sun or show the sky get an empty range. Bit k:
/// pixel k faces the sun.
std::uint32_t turnToSun(glm::vec3 towardsSun, const std::uint32_t* bits, HitPacket& packet);

/// What a pixel shows.
enum class SeenKind : std::uint8_t {
    sky,
    ground,
    building,
    cut,  ///< the inside of a building that the camera's section cuts open
};

/// What is drawn of trees, as numbers in the bits of a pixel.
enum class TreePart : std::uint8_t {
    evergreen,  ///< crowns that keep their leaves
    leafy,      ///< crowns in leaf of trees that lose them
    trunk,
    bare,  ///< crowns without leaves: one sees through them
};

/// What a pixel of a camera shows, packed for a shader.
struct TracedPixel {
    /// Along the camera's forward direction; without meaning for the sky. Negative: seen through a bare
    /// crown.
    float depthM = 0;
    /// Bits 0 to 23: x, y and z of the unit normal, which faces the eye, from -1 to 1 as 0 to 254. Bits 24
    /// and 25: the kind, or with bit 31 the part of a tree. Bit 26: an edge, see isEdge(). Bit 27: in the sun
    /// of TracedSpace. Bit 28: a marked building of TracedSpace. Bit 29: in the shade of crowns, dense, or
    /// with bit 27 light. Bit 30 is set, so that the bits are those of an ordinary float, which textures
    /// hold.
    std::uint32_t bits = 0;

    static constexpr unsigned kindShift = 24, edgeBit = 26, sunBit = 27, markedBit = 28, crownBit = 29;
    static constexpr std::uint32_t tree = 1U << 31;
    static constexpr std::uint32_t ordinary = 1U << 30;
    static constexpr std::uint32_t bitsOf(SeenKind kind) { return std::uint32_t(kind) << kindShift; }
    static constexpr std::uint32_t sky = 0x7f7f7fU;                            ///< normal (0, 0, 0)
    static constexpr std::uint32_t levelGround = 0xfe7f7fU | 1U << kindShift;  ///< normal (0, 0, 1)
};
SeenKind kindOf(TracedPixel pixel);                     ///< building for trees
std::optional<TreePart> treePartOf(TracedPixel pixel);  ///< none: not of a tree
bool isBehindBareCrown(TracedPixel pixel);
glm::vec3 normalOf(TracedPixel pixel);  ///< to 0.5 degrees
/// Whether a neighbour shows another building, another side of it, or nothing of it, and lies farther away.
/// Ground and trees have no edges of their own.
bool isEdge(TracedPixel pixel);
bool isInSun(TracedPixel pixel);
bool isUnderCrown(TracedPixel pixel);  ///< of pixels in the sun: light shade
bool isMarked(TracedPixel pixel);

/// What the pixels of a camera show.
struct TracedView {
    int widthPx = 0;
    int heightPx = 0;
    std::vector<TracedPixel> pixels;  ///< row 0 is the TOP
    std::vector<std::uint32_t> hits;  ///< of each pixel, as HitPacket::hit; `nothing` for trees
    std::vector<std::uint8_t> edges;  ///< of each pixel, 1: isEdge()
};

/// Some of the trees in a picture: a scene of crowns and trunks, and what each of its groups is.
struct TracedTrees {
    RayScene scene;
    std::vector<TreePart> parts;
};

/// What is traced, and how far.
struct TracedSpace {
    float groundM = 0;  ///< z of the level plane around and below the city
    /// The plane is lit as the terrain above it, or as if the terrain went on from its border: no step
    /// down to the plane throws a shadow. Null: the plane is the ground.
    const Terrain* terrain = nullptr;
    float nearM = 0;  ///< depths that a pixel shows
    float farM = std::numeric_limits<float>::max();
    /// Columns of the picture from firstColumn up to lastColumn; the others keep what they were.
    int firstColumn = 0;
    int lastColumn = std::numeric_limits<int>::max();
    /// One entry a building of the scene, 1: it is left out. Empty: none is.
    std::span<const std::uint8_t> hidden{};
    /// One entry a building of the scene, 1: its pixels are marked. Empty: none are.
    std::span<const std::uint8_t> marked{};
    /// A unit vector: finds which pixels are in the sun. Hidden buildings cast shadows, too.
    std::optional<glm::vec3> towardsSun{};
    /// Trees between the eye and the city. Their crowns throw shade, bare ones a light one; trunks do not.
    std::span<const TracedTrees> trees{};
};

/// Traces one ray through the centre of each pixel, and one from there to the sun. `camera` in range (see
/// findVisibleSurface()). `view` is overwritten; its memory is used again. Uses all cores: a million pixels
/// of a city take 20 ms on two cores with AVX-512.
void traceView(const RayScene& scene, const PixelCamera& camera, const TracedSpace& space, TracedView& view);

}  // namespace noonmark
