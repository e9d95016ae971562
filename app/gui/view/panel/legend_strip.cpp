#include "app/gui/view/panel/legend_strip.h"

#include <QApplication>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <cmath>

#include "app/gui/base/looks/theme.h"
#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/view/panel/legend_editor.h"
#include "app/report/maps/map_view.h"
#include "app/report/maps/sheet_text.h"

namespace noonmark {

namespace {

constexpr int stripHeight = 58;
constexpr int legendRowHeight = 46;  // if the strip is narrow
constexpr int minWidth = 720;        // minimum for a single row, with a scale bar and a note of a few words
constexpr int minLegendWidth = 250;
constexpr int maxLegendWidth = 640;
constexpr int measureWidth = 190;
constexpr int margin = 10;
constexpr int needleRoom = 40;
constexpr int scaleRoom = 90;      // of the scale bar left of the needle
constexpr int minWithScale = 560;  // a narrower strip has no scale bar
constexpr int longestBarPx = 60;
constexpr QColor partColour{0xff, 0xd5, 0x8a};

void paintNeedle(QPainter& painter, const QColor& colour, bool north) {
    const double tip = north ? -17 : 17;
    QPainterPath half;
    half.moveTo(0, tip);
    half.lineTo(5, 0);
    half.lineTo(-5, 0);
    half.closeSubpath();
    painter.fillPath(half, colour);
}

void paintCompass(const Canvas& canvas, QPointF centre, double headingDeg) {
    QPainter& painter = canvas.painter;
    painter.save();
    painter.translate(centre);
    painter.rotate(-headingDeg);
    paintNeedle(painter, canvas.inks.line, false);
    paintNeedle(painter, canvas.inks.text, true);
    painter.setPen(canvas.inks.text);
    painter.setFont(textFont(canvas, 10, QFont::Bold));
    painter.drawText(QRectF(-8, -29, 16, 12), Qt::AlignCenter, QStringLiteral("N"));
    painter.restore();
}

int compassWidth(int stripWidth) { return needleRoom + (stripWidth < minWithScale ? 0 : scaleRoom); }

QSizeF sizeOf(const QString& words, const QFont& font, double width) {
    return QFontMetricsF(font).boundingRect({0, 0, width, 1e4}, Qt::TextWordWrap, words).size();
}

QSpinBox* changeScaleField() {
    auto* field = new QSpinBox;
    field->setObjectName(QStringLiteral("changeScale"));
    field->setRange(0, int(ChangeScale::maxLockedMin));
    field->setSingleStep(15);
    field->setKeyboardTracking(false);
    field->setPrefix(QStringLiteral("±"));
    field->setSuffix(LegendStrip::tr(" min"));
    field->setSpecialValueText(LegendStrip::tr("Automatic"));
    field->setMinimumWidth(field->sizeHint().width());
    field->setToolTip(
        LegendStrip::tr("The ends of the colour scale of a difference.\nLock it to compare pictures of "
                        "several proposals; 0: automatic, fitted to each difference."));
    return field;
}

// In the dark theme the style's own pressed button looks like the other.
void paintShown(QToolButton& button) {
    const QPalette palette = QApplication::palette();
    const auto colour = [&](QPalette::ColorRole role) { return palette.color(role).name(); };
    button.setStyleSheet(QStringLiteral("QToolButton { background: %1; color: %2; border: 1px solid %3; } "
                                        "QToolButton:checked { background: %4; color: %5; }")
                             .arg(colour(QPalette::Button), colour(QPalette::ButtonText),
                                  colour(QPalette::Mid), colour(QPalette::Highlight),
                                  colour(QPalette::HighlightedText)));
}

QToolButton* shownButton(const char* name, const QString& text, const QString& tip) {
    auto* button = new QToolButton;
    button->setObjectName(QLatin1String(name));
    button->setText(text);
    button->setToolTip(tip);
    button->setCheckable(true);
    button->setAutoExclusive(true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    return button;
}

bool fits(const QString& words, const QFont& font, const QSizeF& room) {
    const QSizeF size = sizeOf(words, font, room.width());
    return size.width() <= room.width() && size.height() <= room.height();
}

// The note, shortened to its first words if it does not fit.
QString elideNote(const QString& note, const QFont& font, const QSizeF& room) {
    if (fits(note, font, room)) return note;
    QStringList words = note.split(QLatin1Char(' '));
    const auto some = [&words] { return words.join(QLatin1Char(' ')) + QChar(0x2026); };
    while (words.size() > 1 && !fits(some(), font, room)) words.removeLast();
    return some();
}

QString translatedWord(const QString& word) { return translated(word.toStdString()); }

// app/report writes the words of legends in English, for sheets and files.
Legend translatedLegend(Legend legend) {
    legend.title = translatedWord(legend.title);
    legend.unit = localiseNumbers(translatedWord(legend.unit));
    for (LegendNote& note : legend.notes) note = {translatedWord(note.text), localiseNumbers(note.number)};
    for (auto* patches : {&legend.classes, &legend.patches})
        for (LegendPatch& patch : *patches) patch.label = translatedWord(patch.label);
    legend.numbers = QLocale();
    legend.numbers.setNumberOptions(QLocale::OmitGroupSeparator);
    return legend;
}

}  // namespace

LegendStrip::LegendStrip(QWidget* parent)
    : QWidget(parent),
      measure_(new QComboBox),
      scale_(changeScaleField()),
      shadow_(shownButton("showShadow", tr("Shadow"), tr("Show minutes in shadow"))),
      sun_(shownButton(
          "showSun", tr("Sun"),
          tr("Show hours of sun a day: the sunlit time minus gross shadow, on maps, legends and what "
             "is exported.\nContinuous shadow stays as it is: the longest run in the sun does not "
             "follow from it."))) {
    setFixedHeight(stripHeight);
    // The strip, since widgets with a style sheet are not told of another palette.
    followTheme(*this, [this] {
        for (QToolButton* button : {shadow_, sun_}) paintShown(*button);
    });
    measure_->setObjectName(QStringLiteral("measure"));
    measure_->addItem(translatedWord(nameOf(ShadowMeasure::gross)));
    measure_->addItem(translatedWord(nameOf(ShadowMeasure::continuous)));
    measure_->setToolTip(
        tr("What is displayed.\nGross shadow: minutes in shadow per day, mean over the days.\nContinuous "
           "shadow: longest unbroken run in shadow on any day, minutes."));
    measure_->setFixedWidth(measureWidth - 24);
    connect(measure_, &QComboBox::currentIndexChanged, this, &LegendStrip::measureChanged);
    setFocusPolicy(Qt::TabFocus);
    setMouseTracking(true);
    scale_->hide();
    setChangeScale({});
    connect(scale_, &QSpinBox::valueChanged, this, [this](int minutes) {
        changeScale_.lockedMin = minutes > 0 ? std::optional<double>(minutes) : std::nullopt;
        Q_EMIT changeScaleChanged();
    });
    auto* fields = new QWidget;
    fields->setFixedHeight(stripHeight);
    auto* column = new QVBoxLayout(fields);
    column->setContentsMargins(0, 3, 0, 1);
    column->setSpacing(1);
    auto* below = new QHBoxLayout;
    below->setSpacing(1);
    for (QWidget* field : std::initializer_list<QWidget*>{shadow_, sun_, scale_}) below->addWidget(field);
    column->addWidget(measure_);
    column->addLayout(below);
    fields->setFixedWidth(measureWidth - 24);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 0, 12, 0);
    row->addWidget(fields, 0, Qt::AlignTop);
    row->addStretch(1);
    connectShown();
    setChoice({});
}

void LegendStrip::connectShown() {
    const auto show = [this](ShownAs as) {
        if (isOfPlaces()) {
            setShownOfPlaces(as);
            return Q_EMIT shownChosen();
        }
        const auto& colours = legend_ ? legend_->colours : std::nullopt;
        if (choice_.show != as) choose(showAs(choice_, as, colours ? colours->quantity.sunlitMin : 0));
    };
    connect(shadow_, &QToolButton::clicked, this, [show] { show(ShownAs::shadow); });
    connect(sun_, &QToolButton::clicked, this, [show] { show(ShownAs::sun); });
}

bool LegendStrip::isOfPlaces() const {
    return legend_ && legend_->colours && LegendEditor::isOfPlaces(*legend_->colours);
}

void LegendStrip::setShownOfPlaces(ShownAs show) {
    if (show == shownOfPlaces_) return;
    shownOfPlaces_ = show;
    checkShown();
    Q_EMIT placesShownChanged();
    updateEditor();
}

void LegendStrip::checkShown() {
    const ShownAs show = isOfPlaces() ? shownOfPlaces_ : choice_.show;
    (show == ShownAs::shadow ? shadow_ : sun_)->setChecked(true);
}

void LegendStrip::setChoice(const LegendChoice& choice) {
    before_.clear();
    takeChoice(choice);
}

void LegendStrip::choose(const LegendChoice& choice) {
    const bool switched = choice.show != choice_.show;
    before_.push_back(choice_);
    takeChoice(choice);
    if (switched) Q_EMIT shownChosen();
}

void LegendStrip::chooseTrees(TreeColumns trees) {
    LegendChoice choice = choice_;
    choice.trees = trees;
    if (choice != choice_) choose(choice);
}

void LegendStrip::undoChoice() {
    if (before_.empty()) return;
    const LegendChoice last = before_.back();
    before_.pop_back();
    const bool switched = last.show != choice_.show;
    takeChoice(last);
    if (switched) Q_EMIT shownChosen();
}

void LegendStrip::takeChoice(const LegendChoice& choice) {
    choice_ = choice;
    checkShown();
    Q_EMIT choiceChanged();
    updateEditor();
}

void LegendStrip::edit() {
    if (!editor_) {
        editor_ = new LegendEditor(this);
        connect(editor_, &LegendEditor::chosen, this, &LegendStrip::choose);
        connect(editor_, &LegendEditor::undoRequested, this, &LegendStrip::undoChoice);
        connect(editor_, &LegendEditor::closed, this, &LegendStrip::takeKeys, Qt::QueuedConnection);
    }
    updateEditor();
    editor_->adjustSize();
    // Over the panels at the left, so that the map whose colours change stays in sight.
    editor_->move(window()->mapToGlobal(QPoint()).x(),
                  mapToGlobal(QPoint()).y() - editor_->frameGeometry().height() - 2 * margin);
    editor_->show();
    editor_->raise();
    editor_->activateWindow();
}

// A tool window takes the keys with it when it closes: no window has them until one is activated. Asked for
// before it is gone, the window manager gives them back to it.
void LegendStrip::takeKeys() {
    window()->activateWindow();
    setFocus(Qt::OtherFocusReason);
}

void LegendStrip::updateEditor() {
    if (!editor_) return;
    editor_->setHoursShown(!isOfPlaces() || shownOfPlaces_ == ShownAs::sun);
    editor_->setChoice(choice_, legend_ ? legend_->colours : std::nullopt);
    editor_->setCanUndo(!before_.empty());
}

void LegendStrip::mousePressEvent(QMouseEvent* event) {
    if (legend_ && event->button() == Qt::LeftButton && legendArea().contains(event->position()))
        return edit();
    QWidget::mousePressEvent(event);
}

void LegendStrip::keyPressEvent(QKeyEvent* event) {
    const bool opens = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (legend_ && opens) return edit();
    QWidget::keyPressEvent(event);
}

// A fractional scale from the command line is rounded in the field only; the value itself stays.
void LegendStrip::setChangeScale(const ChangeScale& scale) {
    const QSignalBlocker block(scale_);
    scale_->setValue(scale.lockedMin ? std::max(1, int(std::lround(*scale.lockedMin))) : 0);
    if (changeScale_.lockedMin == scale.lockedMin) return;
    changeScale_.lockedMin = scale.lockedMin;
    Q_EMIT changeScaleChanged();
}

void LegendStrip::setLegend(std::optional<Legend> legend) {
    legend_ = std::move(legend);
    scale_->setVisible(legend_ && legend_->change && !legend_->instant &&
                       legend_->colours->of == ColourScale::Of::change);
    const bool ofPlaces = isOfPlaces();
    measure_->setHidden(ofPlaces);
    checkShown();
    updateEditor();
    update();
}

void LegendStrip::setHint(const QString& hint) {
    hint_ = hint;
    update();
}

void LegendStrip::setNote(const QString& note, bool partial) {
    note_ = note;
    partial_ = partial;
    placeNote();
    update();
}

void LegendStrip::setHeading(double degrees) {
    headingDeg_ = degrees;
    update();
}

void LegendStrip::setScale(double pixelsPerM) {
    pixelsPerM_ = pixelsPerM;
    update();
}

// Distances in a slanting view shrink with depth; the bar holds for its middle.
void LegendStrip::paintScale(const Canvas& canvas) const {
    if (pixelsPerM_ <= 0 || width() < minWithScale) return;
    const QRectF area(width() - compassWidth(width()) + 8.0, 16, scaleRoom - 8.0, stripHeight - 24.0);
    paintScaleBar(canvas, area, scaleBarWithin(longestBarPx / pixelsPerM_, unitsInUse()), pixelsPerM_);
}

ShadowMeasure LegendStrip::measure() const { return ShadowMeasure(measure_->currentIndex()); }

void LegendStrip::setMeasure(ShadowMeasure measure) { measure_->setCurrentIndex(int(measure)); }

bool LegendStrip::narrow() const { return width() < minWidth; }

// Smaller where a long note needs it.
QFont LegendStrip::noteFont() const {
    constexpr double minPt = 7, smallerPt = 0.5;
    QFont font = this->font();
    font.setBold(partial_);
    font.setPointSizeF(std::max(minPt, font.pointSizeF() - 1));
    while (font.pointSizeF() > minPt && !fits(note_, font, noteRoom()))
        font.setPointSizeF(std::max(minPt, font.pointSizeF() - smallerPt));
    return font;
}

// The room between measure and compass, without that of a legend beside the note.
QSizeF LegendStrip::noteRoom() const {
    const double between = width() - measureWidth - compassWidth(width()) - 4 * margin;
    const double maximum = narrow() ? between : std::min(between / 2, between - minLegendWidth);
    return {std::max(0.0, maximum), stripHeight - 12.0};
}

QString LegendStrip::paintedNote() const {
    return note_.isEmpty() ? QString() : elideNote(note_, noteFont(), noteRoom());
}

// A tooltip shows the whole note if it was shortened.
void LegendStrip::placeNote() { setToolTip(paintedNote() == note_ ? QString() : note_); }

// The note is left of the compass.
QRectF LegendStrip::noteArea() const {
    if (note_.isEmpty()) return {};
    const QSizeF room = noteRoom(), words = sizeOf(paintedNote(), noteFont(), room.width());
    const double wide = std::min(words.width(), room.width()) + 16,
                 high = std::min(words.height(), room.height()) + 8;
    return {width() - compassWidth(width()) - wide, (stripHeight - high) / 2, wide, high};
}

QRectF LegendStrip::legendArea() const {
    if (narrow()) return {12, stripHeight - 2.0, width() - 24.0, legendRowHeight - 2.0};
    const double right = note_.isEmpty() ? width() - compassWidth(width()) : noteArea().left();
    const double left = measureWidth + margin;
    return {left, 8, std::min(double(maxLegendWidth), right - 2 * margin - left), stripHeight - 10.0};
}

// On amber if the result is partial.
void LegendStrip::paintNote(const Canvas& canvas) const {
    const QRectF chip = noteArea();
    if (chip.isEmpty()) return;
    QPainter& painter = canvas.painter;
    if (partial_) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(partColour);
        painter.drawRoundedRect(chip, 4, 4);
    }
    painter.setFont(noteFont());
    painter.setPen(partial_ ? ink::text : canvas.inks.quiet);
    painter.drawText(chip.adjusted(8, 0, -8, 0), Qt::AlignCenter | Qt::TextWordWrap, paintedNote());
}

void LegendStrip::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    setFixedHeight(narrow() ? stripHeight + legendRowHeight : stripHeight);
    placeNote();
}

void LegendStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Canvas canvas{painter, 1, inksOf(themeInUse())};
    painter.fillRect(rect(), canvas.inks.paper);
    painter.fillRect(QRect(0, 0, width(), 1), canvas.inks.line);
    paintCompass(canvas, {width() - needleRoom / 2.0, stripHeight / 2.0 + 6}, headingDeg_);
    paintScale(canvas);
    paintNote(canvas);
    const QRectF area = legendArea();
    const SheetScope words;
    if (legend_)
        return paintLegend({painter, area.height() / legendHeightPt, canvas.inks}, area,
                           translatedLegend(*legend_));
    painter.setPen(canvas.inks.quiet);
    painter.setFont(font());
    painter.drawText(area, Qt::AlignVCenter | Qt::AlignLeft | Qt::TextWordWrap, hint_);
}

}  // namespace noonmark
