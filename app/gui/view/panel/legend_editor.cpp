#include "app/gui/view/panel/legend_editor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <algorithm>

#include "app/gui/base/widgets/error_text.h"

namespace noonmark {

namespace {

using ClassKind = LegendClasses::Kind;

constexpr QSize swatch{96, 12};

QIcon rampIcon(Ramp ramp) {
    QPixmap picture(swatch);
    QPainter painter(&picture);
    for (int x = 0; x < swatch.width(); ++x) {
        const Rgb colour = rampRgb(ramp, double(x) / (swatch.width() - 1));
        painter.fillRect(x, 0, 1, swatch.height(), QColor(colour.red, colour.green, colour.blue));
    }
    return picture;
}

QComboBox* rampField() {
    auto* field = new QComboBox;
    field->setIconSize(swatch);
    field->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    field->setToolTip(LegendEditor::tr(
        "Colours from much sun to much shadow; of differences and scores those around a pale middle"));
    return field;
}

QComboBox* shownField() {
    auto* field = new QComboBox;
    for (const Choice<ShownAs>& one : shownChoices()) field->addItem(translated(one.label));
    field->setToolTip(
        LegendEditor::tr("Minutes in shadow, hours of sun (the sunlit time minus gross shadow), or the share "
                         "of the sunlit time "
                         "in the sun.\nContinuous shadow stays in minutes: the longest run in the sun does "
                         "not follow from it."));
    return field;
}

QComboBox* kindField() {
    auto* field = new QComboBox;
    field->addItems({LegendEditor::tr("Continuous"), LegendEditor::tr("Equal classes"),
                     LegendEditor::tr("Quantiles: as many cells in each"),
                     LegendEditor::tr("Typed numbers, or one threshold")});
    return field;
}

QLineEdit* textField(const QString& hint, const QString& tip) {
    auto* field = new QLineEdit;
    field->setPlaceholderText(hint);
    field->setToolTip(tip);
    return field;
}

std::string withoutSpaces(const QLineEdit& field) {
    return field.text().simplified().remove(QLatin1Char(' ')).toStdString();
}

}  // namespace

LegendEditor::LegendEditor(QWidget* parent)
    : QFrame(parent, Qt::Tool),
      show_(shownField()),
      ramp_(rampField()),
      reversed_(new QCheckBox(tr("Re&versed"))),
      locked_(new QCheckBox(tr("&Locked"))),
      range_(textField(tr("fitted"), tr("Values at the ends, in the unit shown, such as 0:8"))),
      kind_(kindField()),
      count_(new QSpinBox),
      breaks_(textField(QStringLiteral("2,4,6"),
                        tr("Numbers between the classes, ascending, in the unit shown. One number is a "
                           "threshold: two colours"))),
      problem_(new QLabel),
      undo_(new QPushButton(tr("&Undo"))) {
    setObjectName(QStringLiteral("legendEditor"));
    setWindowTitle(tr("Legend"));
    locked_->setToolTip(tr("Keep the range of this map for all others; unlocked, each map has its own."));
    count_->setRange(LegendClasses::minCount, LegendClasses::maxCount);
    problem_->setWordWrap(true);
    undo_->setShortcut(QKeySequence::Undo);
    undo_->setEnabled(false);
    for (const auto& [field, name] :
         std::initializer_list<std::pair<QWidget*, const char*>>{{show_, "legendShow"},
                                                                 {ramp_, "legendRamp"},
                                                                 {reversed_, "legendReversed"},
                                                                 {locked_, "legendLocked"},
                                                                 {range_, "legendRange"},
                                                                 {kind_, "legendClasses"},
                                                                 {count_, "legendCount"},
                                                                 {breaks_, "legendBreaks"},
                                                                 {undo_, "legendUndo"}})
        field->setObjectName(QLatin1String(name));
    addRows();
    connectRows();
}

void LegendEditor::addRows() {
    auto* form = new QFormLayout(this);
    const auto addPair = [form](const QString& label, QWidget* first, QWidget* second) {
        auto* row = new QHBoxLayout;
        row->addWidget(first, 1);
        row->addWidget(second);
        auto* text = new QLabel(label);
        text->setBuddy(first);
        form->addRow(text, row);
    };
    form->addRow(tr("&Show"), show_);
    form->addRow(tr("&Colours"), ramp_);
    form->addRow(QString(), reversed_);
    addPair(tr("&Range"), range_, locked_);
    addPair(tr("Cla&sses"), kind_, count_);
    form->addRow(tr("&Numbers"), breaks_);
    form->addRow(problem_);
    auto* close = new QPushButton(tr("Close"));
    close->setObjectName(QStringLiteral("legendClose"));
    close->setShortcut(Qt::Key_Escape);
    connect(close, &QPushButton::clicked, this, &QWidget::close);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(undo_);
    buttons->addWidget(close);
    form->addRow(QString(), buttons);
}

void LegendEditor::closeEvent(QCloseEvent* event) {
    QFrame::closeEvent(event);
    Q_EMIT closed();
}

void LegendEditor::connectRows() {
    for (QComboBox* field : {show_, ramp_, kind_})
        connect(field, &QComboBox::currentIndexChanged, this, &LegendEditor::take);
    connect(reversed_, &QCheckBox::toggled, this, &LegendEditor::take);
    connect(count_, &QSpinBox::valueChanged, this, &LegendEditor::take);
    for (QLineEdit* field : {range_, breaks_})
        connect(field, &QLineEdit::editingFinished, this, &LegendEditor::take);
    connect(locked_, &QCheckBox::toggled, this, [this](bool locked) {
        range_->setText(locked && fitted_
                            ? QString::fromStdString(formatText(LegendRange{fitted_->low, fitted_->high}))
                            : QString());
        take();
    });
    connect(undo_, &QPushButton::clicked, this, &LegendEditor::undoRequested);
}

void LegendEditor::setChoice(const LegendChoice& choice, const std::optional<ColourScale>& fitted) {
    choice_ = choice;
    fitted_ = fitted;
    const QSignalBlocker blocks[]{QSignalBlocker(show_),   QSignalBlocker(ramp_), QSignalBlocker(reversed_),
                                  QSignalBlocker(locked_), QSignalBlocker(kind_), QSignalBlocker(count_)};
    show_->setCurrentIndex(int(isOfPlaces() ? ShownAs::sun : choice.show));
    kind_->setItemText(0, isOfPlaces() ? tr("By the threshold of the panel Places") : tr("Continuous"));
    fillRamps();
    const LegendClasses& classes = aroundZero() ? choice.changeClasses : choice.classes;
    reversed_->setChecked(aroundZero() ? choice.changeReversed : choice.reversed);
    const bool isTyped = !isOfPlaces() || choice.show == ShownAs::sun;  // else in another unit
    const bool isLocked = choice.range && isTyped;
    locked_->setChecked(isLocked);
    range_->setText(isLocked ? QString::fromStdString(formatText(*choice.range)) : QString());
    const bool hasBreaks = classes.kind == ClassKind::breaks;
    kind_->setCurrentIndex(int(hasBreaks && !isTyped ? ClassKind::continuous : classes.kind));
    count_->setValue(classes.count);
    breaks_->setText(hasBreaks && isTyped ? QString::fromStdString(formatText(classes)) : QString());
    showEnabled();
}

void LegendEditor::fillRamps() {
    ramp_->clear();
    const auto ramps = listRamps();
    for (const Choice<Ramp>& one : ramps) {
        const QString name = translated(one.label);
        ramp_->addItem(rampIcon(one.value), isColourBlindSafe(one.value)
                                                ? tr("%1 (safe for colour-blind readers)").arg(name)
                                                : tr("%1 (not for colour-blind readers)").arg(name));
    }
    const Ramp chosen = isOfPlaces() && !aroundZero() ? fitted_->ramp
                        : aroundZero()                ? choice_.changeRamp
                                                      : choice_.ramp;
    ramp_->setCurrentIndex(int(std::ranges::find(ramps, chosen, &Choice<Ramp>::value) - ramps.begin()));
}

// Places have a ramp of their own in place of the usual one (makeThresholdScale()).
std::vector<Choice<Ramp>> LegendEditor::listRamps() const {
    const auto all = aroundZero() ? changeRampChoices() : rampChoices();
    std::vector<Choice<Ramp>> ramps(all.begin(), all.end());
    if (isOfPlaces() && !aroundZero())
        std::erase_if(ramps, [](const Choice<Ramp>& one) { return one.value == LegendChoice().ramp; });
    return ramps;
}

// The scale of sun by place knows no sunlit time; until classes are chosen, the threshold of its panel makes
// them.
bool LegendEditor::isOfPlaces() const { return fitted_ && isOfPlaces(*fitted_); }

void LegendEditor::setCanUndo(bool can) { undo_->setEnabled(can); }

void LegendEditor::showEnabled() {
    const auto kind = ClassKind(kind_->currentIndex());
    const bool hasClasses = fitted_.has_value();
    show_->setEnabled(!isOfPlaces());
    for (QWidget* field : {static_cast<QWidget*>(ramp_), static_cast<QWidget*>(reversed_)})
        field->setEnabled(fitted_.has_value());
    for (QWidget* field : {static_cast<QWidget*>(range_), static_cast<QWidget*>(locked_)})
        field->setEnabled(hasClasses && !aroundZero() && hoursShown_);
    kind_->setEnabled(hasClasses);
    count_->setEnabled(hasClasses && (kind == ClassKind::equal || kind == ClassKind::quantiles));
    breaks_->setEnabled(hasClasses && kind == ClassKind::breaks && hoursShown_);
    problem_->setText(!fitted_ ? tr("What is shown has fixed colours: there is nothing to choose")
                      : !hoursShown_
                          ? tr("Range and numbers are hours of sun a day: switch to Sun to change them")
                      : isOfPlaces() ? tr("Range and numbers are hours of sun a day")
                      : aroundZero() ? tr("A difference has its range beside the legend; a score is fitted")
                                     : QString());
}

std::optional<LegendClasses> LegendEditor::readClasses() const {
    const auto kind = ClassKind(kind_->currentIndex());
    if (kind != ClassKind::breaks) return LegendClasses{kind, count_->value(), {}};
    const auto breaks = parseLegendClasses(withoutSpaces(*breaks_));
    if (!breaks || breaks->kind != ClassKind::breaks) return std::nullopt;
    return *breaks;
}

// What is typed for places is in hours, so legends show sun from then on. A range of shadow stays.
LegendChoice LegendEditor::withHours(LegendChoice choice, const LegendClasses& classes,
                                     const std::optional<LegendRange>& range) {
    if (range || classes.kind == ClassKind::breaks) choice.show = ShownAs::sun;
    if (choice.show == ShownAs::sun) choice.range = range;
    choice.classes = classes;
    return choice;
}

std::optional<LegendChoice> LegendEditor::readRows() const {
    const auto classes = readClasses();
    const auto range =
        range_->text().isEmpty() ? Result<LegendRange>() : parseLegendRange(withoutSpaces(*range_));
    if (!classes || !range) return std::nullopt;
    LegendChoice choice = choice_;
    const Ramp ramp = fitted_ ? listRamps()[std::size_t(ramp_->currentIndex())].value : choice.ramp;
    if (aroundZero()) {
        choice.changeRamp = ramp;
        choice.changeReversed = reversed_->isChecked();
        choice.changeClasses = *classes;
        if (isOfPlaces() && classes->kind == ClassKind::breaks) choice.show = ShownAs::sun;
    } else if (isOfPlaces()) {
        if (ramp != fitted_->ramp) choice.ramp = ramp;  // else the usual one stays that of other maps
        choice.reversed = reversed_->isChecked();
        return withHours(choice, *classes, range_->text().isEmpty() ? std::nullopt : std::optional(*range));
    } else if (fitted_) {
        choice.ramp = ramp;
        choice.reversed = reversed_->isChecked();
        choice.classes = *classes;
        choice.range = range_->text().isEmpty() ? std::nullopt : std::optional(*range);
    }
    const auto as = ShownAs(show_->currentIndex());
    return as == choice.show || isOfPlaces() ? choice
                                             : showAs(choice, as, fitted_ ? fitted_->quantity.sunlitMin : 0);
}

// What cannot be read yet stays in its field; the map keeps the colours it has.
void LegendEditor::take() {
    showEnabled();
    const auto choice = readRows();
    if (!choice) problem_->setText(tr("Not two numbers like 0:8, or not ascending numbers like 2,4,6"));
    if (choice && *choice != choice_) Q_EMIT chosen(*choice);
}

}  // namespace noonmark
