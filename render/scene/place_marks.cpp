#include "render/scene/place_marks.h"

#include <QColor>
#include <QFont>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <QRectF>
#include <QVector4D>
#include <Qt3DCore/QEntity>
#include <Qt3DRender/QLayer>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numeric>
#include <utility>

#include "render/scene/picture_texture.h"
#include "render/scene/shader_material.h"

namespace noonmark {

namespace {

constexpr int letterPx = 12;
constexpr int borderPx = 3;  // the light rim around the letters
constexpr double maxLetterWidths = 30;
constexpr QColor nameColour{0x0d, 0x3d, 0x5e};
constexpr QColor boldColour{0x00, 0x2f, 0x86};
constexpr QColor rimColour{0xff, 0xff, 0xff, 225};

QFont fontOf(bool bold) {
    QFont font = QGuiApplication::font();
    font.setPixelSize(letterPx);
    font.setWeight(bold ? QFont::Bold : QFont::DemiBold);
    return font;
}

QString shortened(const QString& name) {
    return QFontMetricsF(fontOf(true)).elidedText(name, Qt::ElideRight, maxLetterWidths * letterPx / 2);
}

// The rim lets a name be read over dark shadow.
void paintName(QPainter& painter, const QString& name, bool bold, const QRectF& box) {
    const QFontMetricsF metrics(fontOf(bold));
    QPainterPath letters;
    const double x = box.center().x() - metrics.horizontalAdvance(name) / 2;
    letters.addText(x, box.center().y() + (metrics.ascent() - metrics.descent()) / 2, fontOf(bold), name);
    painter.setPen(QPen(rimColour, 2.0 * borderPx, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(letters);
    painter.setPen(Qt::NoPen);
    painter.setBrush(bold ? boldColour : nameColour);
    painter.drawPath(letters);
}

/// The picture of all labels, one below the other, at the screen's resolution.
QImage paintNames(const std::vector<NameLabels::Label>& labels, double scale) {
    double width = 1, height = 0;
    for (const auto& label : labels) {
        const QSizeF size = NameLabels::sizeOf(label.name);
        width = std::max(width, size.width());
        height += size.height();
    }
    QImage image(int(std::ceil(width * scale)), int(std::ceil(height * scale)), QImage::Format_RGBA8888);
    image.fill(QColor(255, 255, 255, 0));
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(scale, scale);
    double top = 0;
    for (const auto& label : labels) {
        const QSizeF size = NameLabels::sizeOf(label.name);
        paintName(painter, shortened(label.name), label.bold, {QPointF(0, top), size});
        top += size.height();
    }
    return image;
}

/// The corners of all labels, for the shader `label`.
struct Corners {
    std::vector<glm::vec3> anchors, offsets, texels;
    std::vector<std::uint32_t> triangles;
};

Corners layOut(const std::vector<NameLabels::Label>& labels, const QSizeF& picture) {
    Corners corners;
    double top = 0;
    for (const auto& label : labels) {
        const QSizeF size = NameLabels::sizeOf(label.name);
        const auto first = std::uint32_t(corners.anchors.size());
        for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
            corners.anchors.emplace_back(label.at);
            corners.offsets.emplace_back((x - 0.5) * size.width(), (0.5 - y) * size.height() + label.raisedPx,
                                         0);
            corners.texels.emplace_back(x * size.width() / picture.width(),
                                        (top + y * size.height()) / picture.height(), 0);
        }
        for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U})
            corners.triangles.push_back(first + corner);
        top += size.height();
    }
    return corners;
}

}  // namespace

NameLabels::NameLabels(Qt3DRender::QLayer* blended, Qt3DCore::QEntity* parent)
    : blended_(blended),
      root_(new Qt3DCore::QEntity(parent)),
      material_(new ShaderMaterial(QStringLiteral("label"), root_)) {
    material_->blend();
    material_->alwaysVisible();
    material_->bothSides();
}

QSizeF NameLabels::sizeOf(const QString& name) {
    const QFontMetricsF metrics(fontOf(true));
    return {std::ceil(metrics.horizontalAdvance(shortened(name))) + 2 * borderPx,
            std::ceil(metrics.height()) + 2 * borderPx};
}

void NameLabels::show(const std::vector<Label>& labels) {
    if (labels == shown_) return;
    shown_ = labels;
    delete std::exchange(entity_, nullptr);
    if (labels.empty()) return;
    const double scale = qGuiApp->devicePixelRatio();
    const QImage image = paintNames(labels, scale);
    const QByteArray bytes(reinterpret_cast<const char*>(image.constBits()), image.sizeInBytes());
    Qt3DRender::QAbstractTexture* texture =
        makeByteTexture(bytes, PixelKind::bytes, image.width(), image.height(), root_);
    texture->setMinificationFilter(Qt3DRender::QAbstractTexture::Linear);
    texture->setMagnificationFilter(Qt3DRender::QAbstractTexture::Linear);
    material_->set(QStringLiteral("names"), QVariant::fromValue(texture));
    delete std::exchange(texture_, texture);
    const Corners corners = layOut(labels, QSizeF(image.size()) / scale);
    auto* geometry = new ArrayGeometry(Qt3DRender::QGeometryRenderer::Triangles);
    geometry->addPoints(QStringLiteral("vertexPosition"), corners.anchors);
    geometry->addPoints(QStringLiteral("offset"), corners.offsets);
    geometry->addPoints(QStringLiteral("texel"), corners.texels);
    geometry->setIndices(corners.triangles);
    entity_ = makeArrayEntity(geometry, *material_, root_, blended_);
}

void NameLabels::ignoreSection() { material_->include(QStringLiteral("UNCLIPPED"), true); }

void NameLabels::setViewSize(const QVector2D& size) { material_->set(QStringLiteral("viewSize"), size); }

namespace {

constexpr QColor outlineColour{0x17, 0x5c, 0x8a, 200};
constexpr QColor thinColour{0x17, 0x5c, 0x8a, 120};
constexpr QColor highlightColour{0x00, 0x3f, 0x9e, 255};
constexpr double minNamedPx = 14;  // side of a square as large as a place that still has its name
constexpr double labelGapPx = 4;

ShaderMaterial* makeLine(const QColor& c, float widthPx, Qt3DCore::QNode* parent) {
    auto* line = new ShaderMaterial(QStringLiteral("ribbon"), parent);
    line->set(QStringLiteral("lineColour"), QVector4D(c.redF(), c.greenF(), c.blueF(), c.alphaF()));
    line->set(QStringLiteral("widthPx"), widthPx);
    line->blend();
    line->alwaysVisible();
    line->bothSides();
    return line;
}

double pixelsPerMetre(const CameraPose& pose, const ViewLens& lens, const glm::dvec3& at) {
    return 1 / metresPerPixel(pose, lens, std::max(1.0, glm::distance(computeEye(pose), at)));
}

}  // namespace

PlaceMarks::PlaceMarks(Qt3DRender::QLayer* overlay, Qt3DRender::QLayer* blended, Qt3DCore::QEntity* parent)
    : root_(new Qt3DCore::QEntity(parent)),
      blended_(blended),
      line_(makeLine(outlineColour, 1.6F, root_)),
      thin_(makeLine(thinColour, 1, root_)),
      bold_(makeLine(highlightColour, 4, root_)) {
    root_->addComponent(overlay);
    labels_ = std::make_unique<NameLabels>(blended, root_);
}

PlaceMarks::~PlaceMarks() {
    labels_.reset();
    delete root_;
}

void PlaceMarks::show(std::vector<Mark> marks) {
    const std::vector<Mark> before = std::exchange(marks_, std::move(marks));
    highlighted_.reset();
    hovered_.reset();
    keepNames(before);
    draw();
}

// Names of marks that are gone leave at once; those of others wait for the camera's rest.
void PlaceMarks::keepNames(const std::vector<Mark>& before) {
    std::vector<Named> kept;
    for (std::size_t n = 0; n < named_.size(); ++n) {
        const std::size_t i = named_[n];
        const auto same = std::ranges::find_if(marks_, [&gone = before[i]](const Mark& mark) {
            return mark.name == gone.name && mark.at == gone.at;
        });
        if (same != marks_.end())
            kept.push_back({std::size_t(same - marks_.begin()), labels_->shown()[n].raisedPx});
    }
    showNames(kept);
}

void PlaceMarks::highlight(std::optional<std::size_t> mark) {
    if (mark && *mark >= marks_.size()) mark.reset();
    if (mark == highlighted_) return;
    highlighted_ = mark;
    draw();
}

void PlaceMarks::setShown(bool shown) {
    shown_ = shown;
    draw();
}

void PlaceMarks::setOutlinesShown(bool shown) {
    outlinesShown_ = shown;
    draw();
}

void PlaceMarks::hover(std::optional<std::size_t> mark) {
    if (mark && *mark >= marks_.size()) mark.reset();
    if (mark == hovered_) return;
    hovered_ = mark;
    if (shown_ && !outlinesShown_) drawOutlines();
}

bool PlaceMarks::isOutlined(std::size_t mark) const {
    return mark == highlighted_ || (shown_ && (outlinesShown_ || mark == hovered_));
}

std::size_t PlaceMarks::outlined() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < marks_.size(); ++i)
        count += isOutlined(i) && !marks_[i].lines.empty() ? 1 : 0;
    return count;
}

void PlaceMarks::draw() {
    drawOutlines();
    if (changed_) changed_();
}

void PlaceMarks::drawOutlines() {
    delete std::exchange(lines_, nullptr);
    delete std::exchange(thinLines_, nullptr);
    delete std::exchange(highlightedLines_, nullptr);
    lines_ = drawLines(true, *line_);
    thinLines_ = drawLines(false, *thin_);
    if (highlighted_)
        highlightedLines_ =
            makeArrayEntity(makeOutlineGeometry(marks_[*highlighted_].lines), *bold_, root_, blended_);
}

Qt3DCore::QEntity* PlaceMarks::drawLines(bool named, ShaderMaterial& material) {
    std::vector<GroundLine> lines;
    for (std::size_t i = 0; i < marks_.size(); ++i)
        if (const Mark& mark = marks_[i]; mark.named == named && i != highlighted_ && isOutlined(i))
            lines.insert(lines.end(), mark.lines.begin(), mark.lines.end());
    return lines.empty() ? nullptr : makeArrayEntity(makeOutlineGeometry(lines), material, root_, blended_);
}

std::vector<std::size_t> PlaceMarks::ranked() const {
    std::vector<std::size_t> order(marks_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [this](std::size_t a, std::size_t b) {
        const bool first = a == highlighted_, second = b == highlighted_;
        return first != second ? first : marks_[a].areaM2 > marks_[b].areaM2;
    });
    if (!shown_) order.resize(highlighted_ ? 1 : 0);
    return order;
}

namespace {

// How far a name stands above the point of its place, so that it does not cover a smaller one.
double findRaise(const PlaceMarks::Mark& mark, const glm::dvec2& pixel, const QSizeF& label,
                 const CameraPose& pose, const ViewLens& lens) {
    glm::dvec2 low(1e9), high(-1e9);
    for (const GroundLine& line : mark.lines)
        for (const glm::vec3& point : line.points)
            if (const auto corner = pixelOf(pose, lens, glm::dvec3(point))) {
                low = glm::min(low, glm::dvec2(corner->x, corner->y));
                high = glm::max(high, glm::dvec2(corner->x, corner->y));
            }
    if (high.x - low.x > label.width() && high.y - low.y > label.height()) return 0;
    return high.y < low.y ? 0 : pixel.y - low.y + label.height() / 2;
}

}  // namespace

void PlaceMarks::layNames(const CameraPose& pose, const ViewLens& lens) {
    std::vector<Named> chosen;
    std::vector<QRectF> taken;
    const QRectF screen(0, 0, lens.widthPx, lens.heightPx);
    for (const std::size_t i : ranked()) {
        if (chosen.size() == maxNames) break;
        const Mark& mark = marks_[i];
        const double side = std::sqrt(mark.areaM2) * pixelsPerMetre(pose, lens, mark.at);
        if (i != highlighted_ && (side < minNamedPx || !mark.named)) continue;
        const auto pixel = pixelOf(pose, lens, mark.at);
        if (!pixel || !screen.contains(pixel->x, pixel->y)) continue;
        QRectF box(QPointF(), NameLabels::sizeOf(mark.name));
        const double raisedPx = findRaise(mark, {pixel->x, pixel->y}, box.size(), pose, lens);
        box.moveCenter({pixel->x, pixel->y - raisedPx});
        box.adjust(-labelGapPx, -labelGapPx, labelGapPx, labelGapPx);
        if (!screen.contains(box)) continue;  // a name that is cut off cannot be read
        if (std::ranges::any_of(taken, [&](const QRectF& other) { return other.intersects(box); })) continue;
        if (i != highlighted_ && isHidden_ && isHidden_(mark.at)) continue;
        taken.push_back(box);
        chosen.push_back({i, raisedPx});
    }
    showNames(chosen);
}

void PlaceMarks::showNames(const std::vector<Named>& names) {
    named_.clear();
    std::vector<NameLabels::Label> labels;
    for (const auto& [i, raisedPx] : names) {
        named_.push_back(i);
        labels.push_back({marks_[i].name, marks_[i].at, i == highlighted_, raisedPx});
    }
    labels_->show(labels);
}

void PlaceMarks::setLens(const ViewLens& lens) {
    const QVector2D size(float(lens.widthPx), float(lens.heightPx));
    for (ShaderMaterial* line : {line_, thin_, bold_}) line->set(QStringLiteral("viewSize"), size);
    labels_->setViewSize(size);
}

}  // namespace noonmark
