#include "render/scene/dome_marks.h"

#include <QColor>
#include <QRectF>
#include <QVector2D>
#include <QVector4D>
#include <Qt3DCore/QEntity>
#include <Qt3DRender/QLayer>
#include <algorithm>
#include <utility>

#include "render/scene/array_entity.h"
#include "render/scene/qt_vectors.h"
#include "render/scene/shader_material.h"

namespace noonmark {

namespace {

struct StrokeLook {
    QColor colour;
    float widthPx;
};

// By DomeMarks::Stroke. Warm paths and cool hours, so that they can be told apart where they cross.
constexpr std::array<StrokeLook, DomeMarks::strokes> looks{{{{0x55, 0x6b, 0x86, 130}, 1.0F},
                                                            {{0xa8, 0x6a, 0x1c, 140}, 1.0F},
                                                            {{0x9a, 0x56, 0x08, 215}, 2.0F},
                                                            {{0x4a, 0x55, 0x63, 200}, 1.4F},
                                                            {{0xe0, 0x6c, 0x00, 240}, 2.4F}}};
constexpr QColor sunColour{0xff, 0xa6, 0x00};
constexpr double faintShare = 0.3;  // of the opacity, behind buildings
constexpr double nameGapPx = 2;

ShaderMaterial* makeStroke(const StrokeLook& look, double opacity, Qt3DCore::QNode* parent) {
    auto* line = new ShaderMaterial(QStringLiteral("ribbon"), parent);
    line->set(QStringLiteral("lineColour"),
              QVector4D(toVector(look.colour), look.colour.alphaF() * float(opacity)));
    line->set(QStringLiteral("widthPx"), look.widthPx);
    line->include(QStringLiteral("UNCLIPPED"), true);
    line->blend();
    line->bothSides();
    return line;
}

}  // namespace

DomeMarks::DomeMarks(Qt3DRender::QLayer* overlay, Qt3DRender::QLayer* blended, Qt3DCore::QEntity* parent)
    : root_(new Qt3DCore::QEntity(parent)),
      blended_(blended),
      ball_(new ShaderMaterial(QStringLiteral("mark"), QStringLiteral("overlay"), root_)) {
    root_->addComponent(overlay);
    for (std::size_t i = 0; i < strokes; ++i) {
        styles_[i].seen = makeStroke(looks[i], 1 - faintShare, root_);
        styles_[i].faint = makeStroke(looks[i], faintShare, root_);
        styles_[i].faint->alwaysVisible();
    }
    ball_->set(QStringLiteral("tint"), QVector4D(toVector(sunColour), 1));
    labels_ = std::make_unique<NameLabels>(blended, root_);
    labels_->ignoreSection();
}

DomeMarks::~DomeMarks() {
    labels_.reset();
    delete root_;
}

// The same lines twice: once where nothing hides them, and everywhere.
void DomeMarks::draw(Stroke stroke, const Lines& lines) {
    Style& style = styles_[std::size_t(stroke)];
    delete std::exchange(style.entity, nullptr);
    if (lines.empty()) return;
    style.entity = new Qt3DCore::QEntity(root_);
    for (ShaderMaterial* material : {style.faint, style.seen})
        makeArrayEntity(makeOutlineGeometry(lines), *material, style.entity, blended_);
}

void DomeMarks::show(Net net) {
    net_ = std::move(net);
    for (const Stroke stroke : {Stroke::hour, Stroke::month, Stroke::mainMonth, Stroke::horizon})
        draw(stroke, net_.of(stroke));
    layNames(pose_, lens_);
}

void DomeMarks::showSun(const Sun& sun) {
    sun_ = sun;
    draw(Stroke::day, sun_.lines);
    layNames(pose_, lens_);
    if (!sun_.at) return void(delete std::exchange(ballEntity_, nullptr));
    ball_->set(QStringLiteral("anchor"), toVector(*sun_.at));
    if (!ballEntity_) ballEntity_ = makeArrayEntity(makeMeshGeometry(makeBall(float(sunPx))), *ball_, root_);
}

void DomeMarks::layNames(const CameraPose& pose, const ViewLens& lens) {
    named_.clear();
    std::vector<QRectF> taken;
    const QRectF screen(0, 0, lens.widthPx, lens.heightPx);
    const auto sun = sun_.at ? pixelOf(pose, lens, *sun_.at) : std::nullopt;
    if (sun) taken.emplace_back(sun->x - sunPx / 2, sun->y - sunPx / 2, sunPx, sunPx);
    for (const NameLabels::Label& label : net_.labels) {
        const auto pixel = pixelOf(pose, lens, label.at);
        if (!pixel) continue;
        QRectF box(QPointF(), NameLabels::sizeOf(label.name));
        box.moveCenter({pixel->x, pixel->y});
        box.adjust(-nameGapPx, -nameGapPx, nameGapPx, nameGapPx);
        if (!screen.contains(box)) continue;
        if (std::ranges::any_of(taken, [&](const QRectF& other) { return other.intersects(box); })) continue;
        taken.push_back(box);
        named_.push_back(label);
    }
    labels_->show(named_);
}

void DomeMarks::setLens(const CameraPose& pose, const ViewLens& lens) {
    pose_ = pose;
    lens_ = lens;
    const QVector2D size(float(lens.widthPx), float(lens.heightPx));
    for (const Style& style : styles_)
        for (ShaderMaterial* line : {style.seen, style.faint}) line->set(QStringLiteral("viewSize"), size);
    labels_->setViewSize(size);
    ball_->set(QStringLiteral("metresPerPixel"), float(metresPerPixel(pose, lens, 1)));
}

}  // namespace noonmark
