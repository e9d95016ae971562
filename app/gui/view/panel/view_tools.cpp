#include "app/gui/view/panel/view_tools.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>

#include "app/gui/base/widgets/cursor_label.h"
#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/view/panel/view_panel.h"

namespace noonmark {

namespace {

// Closer points count as the same: a double click sends its place twice.
constexpr double samePointM = 0.01;
constexpr double levelM = 0.05;  // a smaller rise is not stated

double planDistance(glm::dvec3 a, glm::dvec3 b) { return glm::distance(glm::dvec2(a), glm::dvec2(b)); }

double planArea(const std::vector<glm::dvec3>& points) {
    double twice = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 a = points[i] - points[0], b = points[(i + 1) % points.size()] - points[0];
        twice += a.x * b.y - b.x * a.y;
    }
    return std::abs(twice) / 2;
}

}  // namespace

LineMeasures measureLine(const std::vector<glm::dvec3>& points) {
    LineMeasures measures;
    if (points.size() < 2) return measures;
    const glm::dvec3 from = points[points.size() - 2], to = points.back();
    measures.sideM = planDistance(from, to);
    measures.riseM = to.z - from.z;
    measures.slopeM = glm::distance(from, to);
    for (std::size_t i = 1; i < points.size(); ++i)
        measures.lengthM += planDistance(points[i - 1], points[i]);
    if (points.size() > 2) measures.areaM2 = planArea(points);
    return measures;
}

QString describeMeasures(const LineMeasures& measures, UnitSystem units) {
    if (measures.slopeM == 0 && measures.lengthM == 0) return {};
    const auto length = [units](double m) { return QString::fromStdString(formatLength(m, units)); };
    QString words = length(measures.sideM);
    if (std::abs(measures.riseM) >= levelM)
        words = (measures.riseM > 0 ? QObject::tr("%1, %2 up (%3 in space)")
                                    : QObject::tr("%1, %2 down (%3 in space)"))
                    .arg(words, length(std::abs(measures.riseM)), length(measures.slopeM));
    if (measures.areaM2 == 0) return words;
    return QObject::tr("%1\nAll sides %2, area %3")
        .arg(words, length(measures.lengthM),
             QString::fromStdString(formatSmallArea(measures.areaM2, units)));
}

void MeasureTool::begin() {
    points_.clear();
    cursor_.reset();
    active_ = true;
    Q_EMIT activeChanged(true);
    Q_EMIT lineChanged();
}

void MeasureTool::end() {
    if (!active_) return;
    active_ = false;
    points_.clear();
    cursor_.reset();
    Q_EMIT activeChanged(false);
    Q_EMIT lineChanged();
}

void MeasureTool::addPoint(glm::dvec3 point) {
    if (!active_) return;
    if (!points_.empty() && glm::distance(points_.back(), point) < samePointM) return;
    points_.push_back(point);
    Q_EMIT lineChanged();
}

void MeasureTool::moveTo(glm::dvec3 point) {
    if (!active_ || points_.empty()) return;
    cursor_ = point;
    Q_EMIT lineChanged();
}

void MeasureTool::removeLastPoint() {
    if (!active_ || points_.empty()) return;
    points_.pop_back();
    Q_EMIT lineChanged();
}

std::vector<glm::dvec3> MeasureTool::line() const {
    std::vector<glm::dvec3> line = points_;
    if (cursor_ && !points_.empty() && glm::distance(points_.back(), *cursor_) >= samePointM)
        line.push_back(*cursor_);
    return line;
}

namespace {

constexpr double handleReachPx = 14;
constexpr double shortestAxisPx = 0.15;  // of a metre seen across; less: the axis points at the eye

glm::dvec2 pixelFrom(QPointF point) { return {point.x(), point.y()}; }

}  // namespace

SectionTool::SectionTool(CityView& view, ViewNavigator& navigator, CursorLabel& label, QObject* parent)
    : QObject(parent), view_(view), label_(label) {
    connect(&navigator, &ViewNavigator::hovered, this,
            [this](QPointF pixel) { view_.sectionMarks().light(handleAt(pixel)); });
    navigator.addTarget(*this);
}

// The navigator is a child of the view, which ends before or together with this.
SectionTool::~SectionTool() = default;

void SectionTool::set(const std::optional<SectionBox>& box) {
    view_.showSection(box ? repairSection(*box) : box);
    showMarks();
    Q_EMIT changed();
}

void SectionTool::setAroundCity() { set(makeSectionAround(view_.viewBounds())); }

void SectionTool::setAround(const Box2& ground) {
    SectionBox box = makeSectionAround(view_.viewBounds());
    for (int axis = 0; axis < 2; ++axis) {
        box.lowM[axis] = double(ground.low[axis]);
        box.highM[axis] = double(ground.high[axis]);
    }
    set(box);
}

void SectionTool::showHandles(bool shown) {
    handlesShown_ = shown;
    showMarks();
}

void SectionTool::showMarks() { view_.sectionMarks().show(handlesShown_ ? box() : std::nullopt); }

std::optional<std::size_t> SectionTool::handleAt(QPointF pixel) const {
    if (!handlesShown_ || !box()) return std::nullopt;
    std::optional<std::size_t> nearest;
    double nearestPx = handleReachPx;
    for (std::size_t side = 0; side < std::size(sectionSides); ++side) {
        const auto at = pixelOf(view_.pose(), view_.lens(), centreOf(*box(), sectionSides[side]));
        if (!at || glm::distance(*at, pixelFrom(pixel)) > nearestPx) continue;
        nearestPx = glm::distance(*at, pixelFrom(pixel));
        nearest = side;
    }
    return nearest;
}

glm::dvec2 SectionTool::pixelsPerMetre(const glm::dvec3& at, int axis) const {
    glm::dvec3 step(0);
    step[axis] = 1;
    const auto here = pixelOf(view_.pose(), view_.lens(), at);
    const auto there = pixelOf(view_.pose(), view_.lens(), at + step);
    return here && there ? *there - *here : glm::dvec2(0);
}

bool SectionTool::grab(QPointF pixel) {
    const auto side = handleAt(pixel);
    if (!side) return false;
    const glm::dvec3 at = centreOf(*box(), sectionSides[*side]);
    const glm::dvec2 along = pixelsPerMetre(at, sectionSides[*side].axis);
    const double across =
        1 / metresPerPixel(view_.pose(), view_.lens(), glm::distance(computeEye(view_.pose()), at));
    if (glm::length(along) < shortestAxisPx * across) return false;
    drag_ = Drag{*side, positionOf(*box(), sectionSides[*side]), pixel, along};
    return true;
}

void SectionTool::dragTo(QPointF pixel) {
    if (!drag_ || !box()) return;
    const glm::dvec2 moved = pixelFrom(pixel) - pixelFrom(drag_->fromPx);
    const double byM = glm::dot(moved, drag_->alongPx) / glm::dot(drag_->alongPx, drag_->alongPx);
    const SectionSide side = sectionSides[drag_->side];
    set(moveSide(*box(), side, drag_->startM + byM));
    label_.show(pixel, describeLength(positionOf(*box(), side)));
}

void SectionTool::drop() {
    drag_.reset();
    label_.hide();
}

namespace {

constexpr double farthestFieldM = 200000;

}  // namespace

SectionDialog::SectionDialog(ViewPanel& panel, QWidget* parent)
    : QDialog(parent, Qt::Tool), panel_(panel), tool_(panel.section()) {
    setObjectName(QStringLiteral("sectionDialog"));
    setWindowTitle(tr("Section box"));
    new QVBoxLayout(this);
    addFields();
    addButtons();
    connect(&tool_, &SectionTool::changed, this, &SectionDialog::showBox);
    showBox();
}

void SectionDialog::addFields() {
    const std::array names{tr("West"), tr("East"), tr("South"), tr("North"), tr("Bottom"), tr("Top")};
    auto* form = new QFormLayout;
    for (std::size_t side = 0; side < fields_.size(); ++side) {
        LengthField* field = lengthField(-farthestFieldM, farthestFieldM, 1, 1);
        field->setObjectName(QStringLiteral("section%1").arg(side));
        field->setToolTip(side < 4 ? tr("From the origin of the project, to the east and to the north")
                                   : tr("Height above the origin of the project"));
        connect(field, &QDoubleSpinBox::valueChanged, this, [this, side] { takeField(side); });
        form->addRow(names[side], field);
        fields_[side] = field;
    }
    static_cast<QVBoxLayout*>(layout())->addLayout(form);
}

void SectionDialog::addButtons() {
    auto* row = new QHBoxLayout;
    const auto add = [row](const QString& text, const QString& tip, const char* name) {
        auto* button = new QPushButton(text);
        button->setToolTip(tip);
        button->setObjectName(QString::fromLatin1(name));
        button->setAutoDefault(false);
        row->addWidget(button);
        return button;
    };
    QPushButton* view =
        add(tr("What the view shows"), tr("The box around the ground in view"), "sectionView");
    QPushButton* city = add(tr("Reset"), tr("The box around the whole city"), "sectionReset");
    QPushButton* off = add(tr("Remove"), tr("Shows everything again"), "sectionRemove");
    connect(view, &QPushButton::clicked, this, &SectionDialog::takeView);
    connect(city, &QPushButton::clicked, &tool_, &SectionTool::setAroundCity);
    connect(off, &QPushButton::clicked, this, &SectionDialog::removed);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void SectionDialog::showEvent(QShowEvent* event) {
    tool_.showHandles(true);
    QDialog::showEvent(event);
}

void SectionDialog::hideEvent(QHideEvent* event) {
    tool_.showHandles(false);
    QDialog::hideEvent(event);
}

void SectionDialog::showBox() {
    if (!tool_.box()) return;
    for (std::size_t side = 0; side < fields_.size(); ++side) {
        const QSignalBlocker quiet(fields_[side]);
        fields_[side]->setValue(positionOf(*tool_.box(), sectionSides[side]));
    }
}

void SectionDialog::takeField(std::size_t side) {
    if (tool_.box()) tool_.set(moveSide(*tool_.box(), sectionSides[side], fields_[side]->value()));
}

void SectionDialog::takeView() {
    const Box2 ground = bounds(panel_.visibleGround());
    if (!ground.empty()) tool_.setAround(ground);
}

}  // namespace noonmark
