#pragma once

#include <QColor>
#include <QSize>
#include <Qt3DRender/QFrameGraphNode>
#include <array>
#include <memory>
#include <optional>

#include "render/view/section_box.h"
#include "render/view/view_sides.h"

class QOffscreenSurface;
class QWindow;

namespace Qt3DRender {
class QAbstractTexture;
class QCamera;
class QLayer;
class QParameter;
class QRenderCapture;
class QRenderStateSet;
class QRenderSurfaceSelector;
class QRenderTarget;
class QRenderTargetSelector;
class QSubtreeEnabler;
class QViewport;
}  // namespace Qt3DRender

namespace noonmark {

/// What is drawn where there is nothing; what is far away fades into it.
inline constexpr QColor backgroundColour{0xe7, 0xee, 0xf3};

/// The layers of the view's nodes; nothing is owned.
struct ViewLayers {
    Qt3DRender::QLayer* overlay;               ///< drawn over the city
    Qt3DRender::QLayer* blended;               ///< edges, lines and translucent faces
    std::array<Qt3DRender::QLayer*, 2> sides;  ///< what only one of two sides shows, see ViewSides
    Qt3DRender::QLayer*
        coarse;  ///< what is drawn with fewer pixels, then copied: see FrameGraph::drawCoarse()
};

/// A picture with fewer pixels than the view's, and its depths.
struct CoarsePicture {
    Qt3DRender::QAbstractTexture* colour;
    Qt3DRender::QAbstractTexture* depth;
};

/// The order in which the view is drawn: each side first depths, then colours; in each the city before the
/// overlay and faces before what is blended with them. All nodes are below root().
class FrameGraph {
public:
    /// `surface`: the window.
    FrameGraph(QWindow* surface, Qt3DRender::QCamera* camera, const ViewLayers& layers);
    ~FrameGraph();

    [[nodiscard]] Qt3DRender::QFrameGraphNode* root() const;
    /// Takes pictures of what is drawn.
    [[nodiscard]] Qt3DRender::QRenderCapture* capture() const { return capture_; }
    /// Draws only what lies inside the box; empty: everything.
    void showSection(const std::optional<SectionBox>& box);
    /// `size` of the view in device pixels.
    void setSides(const ViewSides& sides, QSize size);
    /// Draws into a picture of this size, which capture() takes, while the window keeps what it shows; empty:
    /// into the window.
    void drawInto(const std::optional<QSize>& picture);
    /// Before anything else draws the nodes of ViewLayers::coarse into coarsePicture(), which has this size;
    /// empty: leaves them out.
    void drawCoarse(const std::optional<QSize>& size);
    [[nodiscard]] const CoarsePicture& coarsePicture() const { return coarse_; }

private:
    struct Side {
        Qt3DRender::QSubtreeEnabler* enabler;
        Qt3DRender::QViewport* viewport;
        Qt3DRender::QRenderStateSet* states;
    };
    Side makeSide(Qt3DRender::QCamera* camera, Qt3DRender::QLayer* hidden);
    void makeCoarse(Qt3DRender::QCamera* camera);
    void clearAll();
    void makeCapture();
    void drawSide(Qt3DRender::QFrameGraphNode* side);
    Qt3DRender::QFrameGraphNode* passes(const char* pass, Qt3DRender::QFrameGraphNode* parent);
    void draw(bool overlay, bool blended, Qt3DRender::QFrameGraphNode* parent);

    QWindow* window_;
    std::unique_ptr<QOffscreenSurface> offscreen_;  // of pictures; made for the first
    Qt3DRender::QRenderSurfaceSelector* surface_;
    Qt3DRender::QSubtreeEnabler* coarseEnabler_;  // drawn before root_
    CoarsePicture coarse_{};
    Qt3DRender::QRenderTargetSelector* root_;  // of all that is drawn
    Qt3DRender::QRenderTarget* picture_ = nullptr;
    ViewLayers layers_;
    Qt3DRender::QParameter* sectionLow_;
    Qt3DRender::QParameter* sectionHigh_;
    std::array<Side, 2> sides_{};
    Qt3DRender::QRenderCapture* capture_ = nullptr;
    bool clipped_ = false;
};

}  // namespace noonmark
