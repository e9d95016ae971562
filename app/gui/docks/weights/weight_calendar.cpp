#include "app/gui/docks/weights/weights_dock.h"

#include <QHelpEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "app/gui/base/looks/theme.h"
#include "app/gui/docks/weights/weights_model.h"
#include "app/report/maps/style.h"

namespace noonmark {

namespace {

constexpr int months = 12, hoursADay = 24;
constexpr double brushStep = 0.25;
constexpr int swatches = 9;  // -1 to 1
constexpr int cellHeightPx = 13, minCellPx = 8, gapPx = 8;

double weightOfSwatch(int swatch) { return -1 + brushStep * swatch; }

QString monthName(int month) { return QLocale().standaloneMonthName(month + 1, QLocale::ShortFormat); }

QString weightText(double weight) {
    return (weight > 0 ? QStringLiteral("+") : QString()) + QLocale().toString(weight, 'g', 3);
}

}  // namespace

WeightCalendar::WeightCalendar(WeightsModel& model, QWidget* parent) : QWidget(parent), model_(model) {
    setObjectName(QStringLiteral("weightCalendar"));
    setAccessibleName(tr("Weights by month and hour"));
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setToolTip(
        tr("Drag to give months and hours the weight that is chosen below; drag with the right button "
           "to erase it. Keys: arrows, Shift, Enter, Delete, + and -"));
    connect(&model_, &WeightsModel::dataChanged, this, &WeightCalendar::follow);
    connect(&model_, &WeightsModel::rowsInserted, this, &WeightCalendar::follow);
    connect(&model_, &WeightsModel::rowsRemoved, this, &WeightCalendar::follow);
    connect(&model_, &WeightsModel::chosen, this, &WeightCalendar::follow);
    follow();
}

void WeightCalendar::follow() {
    grid_ = weightGrid(model_.table());
    update();
}

void WeightCalendar::setBrush(double weight) {
    brush_ = std::clamp(std::round(weight / brushStep) * brushStep, -1.0, 1.0);
    update();
}

int WeightCalendar::labelWidth() const {
    int widest = 0;
    for (int month = 0; month < months; ++month)
        widest = std::max(widest, fontMetrics().horizontalAdvance(monthName(month)));
    return widest + gapPx;
}

int WeightCalendar::lineHeight() const { return fontMetrics().height(); }

QRectF WeightCalendar::cellAt(int month, int hour) const {
    const double width = (this->width() - labelWidth() - 1) / double(hoursADay);
    return {labelWidth() + hour * width, double(lineHeight() + month * cellHeightPx), width,
            double(cellHeightPx)};
}

double WeightCalendar::swatchTop() const { return cellAt(months, 0).top() + gapPx; }

QRectF WeightCalendar::swatchOf(double weight) const {
    const double width = (this->width() - 1) / double(swatches);
    return {(weight + 1) / brushStep * width, swatchTop(), width, double(lineHeight() + 2)};
}

QSize WeightCalendar::sizeHint() const {
    const int height = int(swatchTop()) + 2 * lineHeight() + gapPx;
    return {labelWidth() + hoursADay * minCellPx, height};
}

QSize WeightCalendar::minimumSizeHint() const { return sizeHint(); }

std::optional<WeightCalendar::Cell> WeightCalendar::findCell(QPointF at) const {
    const QRectF all = cellAt(0, 0).united(cellAt(months - 1, hoursADay - 1));
    if (!all.contains(at)) return std::nullopt;
    const QRectF first = cellAt(0, 0);
    return Cell{std::clamp(int((at.y() - first.top()) / first.height()), 0, months - 1),
                std::clamp(int((at.x() - first.left()) / first.width()), 0, hoursADay - 1)};
}

MonthsAndHours WeightCalendar::selected() const {
    const auto [firstMonth, lastMonth] = std::minmax(anchor_.month, cell_.month);
    const auto [firstHour, lastHour] = std::minmax(anchor_.hour, cell_.hour);
    return {std::chrono::month(unsigned(firstMonth) + 1), std::chrono::month(unsigned(lastMonth) + 1),
            firstHour, lastHour + 1};
}

void WeightCalendar::paintSelected(std::optional<double> weight) { model_.paint(selected(), weight); }

void WeightCalendar::mousePressEvent(QMouseEvent* event) {
    for (int swatch = 0; swatch < swatches; ++swatch)
        if (swatchOf(weightOfSwatch(swatch)).contains(event->position()))
            return setBrush(weightOfSwatch(swatch));
    const auto cell = findCell(event->position());
    if (!cell || (event->button() != Qt::LeftButton && event->button() != Qt::RightButton)) return;
    dragged_ = event->button();
    anchor_ = cell_ = *cell;
    update();
}

void WeightCalendar::mouseMoveEvent(QMouseEvent* event) {
    if (dragged_ == Qt::NoButton) return;
    const QRectF first = cellAt(0, 0), last = cellAt(months - 1, hoursADay - 1);
    const QPointF inside(std::clamp(event->position().x(), first.left(), last.right() - 1),
                         std::clamp(event->position().y(), first.top(), last.bottom() - 1));
    if (const auto cell = findCell(inside)) cell_ = *cell;
    update();
}

void WeightCalendar::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != dragged_) return;
    dragged_ = Qt::NoButton;
    paintSelected(event->button() == Qt::LeftButton ? std::optional(brush_) : std::nullopt);
    update();
}

void WeightCalendar::wheelEvent(QWheelEvent* event) {
    if (!hasFocus()) return event->ignore();  // the dock scrolls
    setBrush(brush_ + (event->angleDelta().y() > 0 ? brushStep : -brushStep));
    event->accept();
}

void WeightCalendar::moveCell(int key, bool extends) {
    if (key == Qt::Key_Up) cell_.month = std::max(0, cell_.month - 1);
    if (key == Qt::Key_Down) cell_.month = std::min(months - 1, cell_.month + 1);
    if (key == Qt::Key_Left) cell_.hour = std::max(0, cell_.hour - 1);
    if (key == Qt::Key_Right) cell_.hour = std::min(hoursADay - 1, cell_.hour + 1);
    if (!extends) anchor_ = cell_;
    update();
}

void WeightCalendar::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Up:
        case Qt::Key_Down:
        case Qt::Key_Left:
        case Qt::Key_Right:
            return moveCell(event->key(), event->modifiers().testFlag(Qt::ShiftModifier));
        case Qt::Key_Return:
        case Qt::Key_Enter:
        case Qt::Key_Space:
            return paintSelected(brush_);
        case Qt::Key_Delete:
        case Qt::Key_Backspace:
            return paintSelected(std::nullopt);
        case Qt::Key_Plus:
            return setBrush(brush_ + brushStep);
        case Qt::Key_Minus:
            return setBrush(brush_ - brushStep);
        default:
            QWidget::keyPressEvent(event);
    }
}

QString WeightCalendar::tipAt(Cell cell) const {
    const WeightCell& held = grid_[std::size_t(cell.month)][std::size_t(cell.hour)];
    const QString when = tr("%1, %2:00 to %3:00")
                             .arg(QLocale().standaloneMonthName(cell.month + 1))
                             .arg(cell.hour)
                             .arg(cell.hour + 1);
    if (!held.isHeld) return when + QLatin1Char('\n') + tr("no weight");
    const QString weight = held.isMixed ? tr("several weights, or none in part; mean %1") : tr("weight %1");
    return when + QLatin1Char('\n') + weight.arg(weightText(held.weight));
}

bool WeightCalendar::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const auto cell = findCell(help->pos());
    QToolTip::showText(help->globalPos(), cell ? tipAt(*cell) : toolTip(), this);
    return true;
}

void WeightCalendar::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    drawLabels(painter);
    drawCells(painter);
    drawSelection(painter);
    drawSwatches(painter);
}

void WeightCalendar::drawLabels(QPainter& painter) const {
    painter.setPen(inksOf(themeInUse()).text);
    for (int month = 0; month < months; ++month) {
        const QRectF row(0, cellAt(month, 0).top(), labelWidth() - gapPx / 2.0, cellHeightPx);
        painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, monthName(month));
    }
    for (int hour = 0; hour <= hoursADay; hour += 6) {
        const double middle = cellAt(0, hour).left();
        const QRectF over(std::min(middle - 20, width() - 41.0), 0, 40, lineHeight());
        painter.drawText(over, hour == hoursADay ? Qt::AlignRight : Qt::AlignHCenter, QString::number(hour));
    }
}

void WeightCalendar::drawCells(QPainter& painter) const {
    const Inks inks = inksOf(themeInUse());
    for (int month = 0; month < months; ++month)
        for (int hour = 0; hour < hoursADay; ++hour) {
            const QRectF box = cellAt(month, hour);
            const WeightCell& cell = grid_[std::size_t(month)][std::size_t(hour)];
            if (cell.isHeld) painter.fillRect(box, impactColour(-cell.weight));
            if (cell.isMixed) painter.fillRect(box, QBrush(ink::quiet, Qt::BDiagPattern));
            painter.setPen(QPen(inks.line, 1));
            painter.drawRect(box);
        }
}

// What a drag or the keys have chosen, in the colour that it will get.
void WeightCalendar::drawSelection(QPainter& painter) const {
    if (dragged_ == Qt::NoButton && !hasFocus()) return;
    const QRectF box = cellAt(anchor_.month, anchor_.hour).united(cellAt(cell_.month, cell_.hour));
    if (dragged_ == Qt::LeftButton) painter.fillRect(box, impactColour(-brush_));
    if (dragged_ == Qt::RightButton) painter.fillRect(box, inksOf(themeInUse()).paper);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
    painter.drawRect(box);
}

void WeightCalendar::drawSwatches(QPainter& painter) const {
    for (int swatch = 0; swatch < swatches; ++swatch) {
        const double weight = weightOfSwatch(swatch);
        const QRectF box = swatchOf(weight).adjusted(1, 1, -1, -1);
        const QColor colour = impactColour(-weight);
        painter.fillRect(box, colour);
        painter.setPen(colour.lightness() > 128 ? Qt::black : Qt::white);
        painter.drawText(box, Qt::AlignCenter, weightText(weight));
        if (weight != brush_) continue;
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.drawRect(box);
    }
    painter.setPen(inksOf(themeInUse()).text);
    const QRectF words(0, swatchOf(0).bottom() + 2, width(), lineHeight());
    painter.drawText(words, Qt::AlignLeft, tr("sun wanted"));
    painter.drawText(words, Qt::AlignRight, tr("shade wanted"));
}

}  // namespace noonmark
