#include "render/scene/name_labels.h"

#include <QFont>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <Qt3DCore/QEntity>
#include <Qt3DRender/QLayer>
#include <algorithm>
#include <cmath>

#include "render/scene/array_entity.h"
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
            corners.offsets.emplace_back((x - 0.5) * size.width(), (0.5 - y) * size.height(), 0);
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

}  // namespace noonmark
