#include "app/gui/docks/study_form/line_form.h"

#include <fmt/format.h>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/looks/theme.h"
#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_fields.h"
#include "core/base/units.h"
#include "core/io/elements/read_point_file.h"

namespace noonmark {

namespace {

// With a point as the decimal sign, since the comma separates the lengths.
QString offsetText(const std::vector<double>& offsetsM) {
    QStringList list;
    for (const double offsetM : offsetsM)
        list << (unitsInUse() == UnitSystem::imperial ? QString::fromStdString(formatFeetAndInches(offsetM))
                                                      : QObject::tr("%1 m").arg(offsetM));
    return list.join(QStringLiteral(", "));
}

// Empty: not a list of distances in range.
std::vector<double> offsetsIn(const QString& text, const QRegularExpression& between) {
    std::vector<double> offsetsM;
    for (const QString& one : text.split(between, Qt::SkipEmptyParts)) {
        const auto offsetM = parseLength(one.toStdString(), unitsInUse());
        if (!offsetM || *offsetM < LineSettings::minOffsetM || *offsetM > LineSettings::maxOffsetM) return {};
        offsetsM.push_back(*offsetM);
    }
    return offsetsM;
}

// A length may contain spaces, 12' 6"; without commas they separate plain numbers, 5 10.
std::vector<double> offsetsIn(const QString& text) {
    static const QRegularExpression commas(QStringLiteral("\\s*[,;]\\s*")), spaces(QStringLiteral("\\s+"));
    const auto offsetsM = offsetsIn(text, commas);
    return offsetsM.empty() ? offsetsIn(text, spaces) : offsetsM;
}

}  // namespace

LineForm::LineForm(QWidget* parent) : QWidget(parent) {
    makeFields();
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->addRow(tr("Parcel"), parcel_);
    form->addRow(tr("Lines"), offsets_);
    form->addRow(tr("Spacing"), spacing_);
    connectFields();
    show({}, {});
}

void LineForm::makeFields() {
    parcel_ = new QComboBox;
    parcel_->setObjectName(QStringLiteral("parcel"));
    parcel_->setEditable(true);
    parcel_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    parcel_->setMinimumContentsLength(12);
    parcel_->lineEdit()->setPlaceholderText(tr("lot or file"));
    const QString tip =
        tr("The parcel that the lines run around: a lot, region or place of the project by its name, or the "
           "path "
           "of a polygon file");
    parcel_->setToolTip(tip);
    parcel_->lineEdit()->setToolTip(tip);
    offsets_ = new QLineEdit;
    offsets_->setObjectName(QStringLiteral("lineOffsets"));
    offsets_->setToolTip(tr("Distances of the lines from the parcel, with commas: 5, 10"));
    spacing_ = lengthField(LineSettings::minSpacingM, LineSettings::maxSpacingM, 2, 0.5);
    spacing_->setObjectName(QStringLiteral("lineSpacing"));
    spacing_->setToolTip(tr("Distance from point to point on a line"));
}

void LineForm::connectFields() {
    const auto takeParcel = [this] {
        const std::string parcel = parcel_->currentText().trimmed().toStdString();
        if (parcel == chosen_) return;
        chosen_ = parcel;
        Q_EMIT edited(chosen_, lines_, tr("parcel"));
    };
    connect(parcel_, &QComboBox::activated, this, takeParcel);
    connect(parcel_->lineEdit(), &QLineEdit::editingFinished, this, takeParcel);
    connect(offsets_, &QLineEdit::editingFinished, this, &LineForm::takeOffsets);
    connect(spacing_, &QDoubleSpinBox::valueChanged, this, [this](double metres) {
        lines_.spacingM = metres;
        Q_EMIT edited(chosen_, lines_, tr("spacing"));
    });
}

// A text that is no list of distances gives way to the last one. An unchanged one means the distances
// themselves, which the text may round.
void LineForm::takeOffsets() {
    if (offsets_->text() == offsetText(lines_.offsetsM)) return;
    const auto offsets = offsetsIn(offsets_->text());
    if (offsets.empty()) return offsets_->setText(offsetText(lines_.offsetsM));
    lines_.offsetsM = offsets;
    offsets_->setText(offsetText(offsets));
    Q_EMIT edited(chosen_, lines_, tr("lines"));
}

void LineForm::show(const std::string& parcel, const LineSettings& lines) {
    chosen_ = parcel;
    lines_ = lines;
    const QSignalBlocker quiet[]{QSignalBlocker(parcel_), QSignalBlocker(spacing_)};
    parcel_->setEditText(QString::fromStdString(parcel));
    offsets_->setText(offsetText(lines.offsetsM));
    spacing_->setValue(lines.spacingM);
}

void LineForm::setLots(const QStringList& names) {
    const QSignalBlocker quiet(parcel_);
    parcel_->clear();
    parcel_->addItems(names);
    parcel_->setEditText(QString::fromStdString(chosen_));
}

PointListForm::PointListForm(QWidget* parent)
    : QWidget(parent),
      text_(new QPlainTextEdit),
      pick_(
          pushButton(tr("Click points"), "pickPoints",
                     tr("Click the ground, roofs or walls in the view: each click adds a point. Press again "
                        "to end"))),
      read_(pushButton(tr("Read CSV..."), "readPoints",
                       tr("Replaces the list by a CSV file with columns id, lon, lat, height, facing"))),
      problem_(new QLabel) {
    text_->setObjectName(QStringLiteral("pointList"));
    text_->setToolTip(tr(
        "One point a line: id, longitude, latitude (degrees), metres above the ground, azimuth that a wall "
        "faces. Without a height the point is on the ground or roof, without an azimuth it is level"));
    text_->setPlaceholderText(QStringLiteral("id,lon,lat,height,facing"));
    text_->setTabChangesFocus(true);
    text_->setLineWrapMode(QPlainTextEdit::NoWrap);
    text_->setFixedHeight(6 * fontMetrics().lineSpacing());
    text_->installEventFilter(this);
    pick_->setCheckable(true);
    problem_->setWordWrap(true);
    problem_->hide();
    showAsError(*problem_);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(pick_);
    buttons->addWidget(read_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(text_);
    column->addWidget(problem_);
    column->addLayout(buttons);
    connect(read_, &QPushButton::clicked, this, &PointListForm::readFile);
    connect(pick_, &QPushButton::toggled, this, [this](bool on) {
        if (on) Q_EMIT pickingBegan();
    });
}

bool PointListForm::eventFilter(QObject* watched, QEvent* event) {
    if (watched == text_ && event->type() == QEvent::FocusOut) take();
    return QWidget::eventFilter(watched, event);
}

// What was typed stays where it is wrong, with the reason below it.
void PointListForm::take() {
    const QString text = text_->toPlainText();
    std::vector<ListedPoint> points;
    if (!text.trimmed().isEmpty()) {
        auto parsed = parsePointList(text.toStdString(), tr("points").toStdString());
        if (!parsed) return report(describeError(parsed.error()));
        points = *std::move(parsed);
    }
    report({});
    if (points == points_) return;
    points_ = std::move(points);
    Q_EMIT edited(points_, tr("points"));
}

void PointListForm::readFile() {
    const QString file = askForPoints(this);
    if (file.isEmpty()) return;
    auto points = readPointFile(file.toStdString());
    if (!points) return report(describeError(points.error()));
    show(*points);
    Q_EMIT edited(points_, tr("points"));
}

void PointListForm::report(const QString& problem) {
    problem_->setText(problem);
    problem_->setVisible(!problem.isEmpty());
}

void PointListForm::show(const std::vector<ListedPoint>& points) {
    if (points == points_ && !text_->toPlainText().isEmpty()) return;
    points_ = points;
    text_->setPlainText(points.empty() ? QString() : QString::fromStdString(toCsv(points)));
    report({});
}

void PointListForm::add(ListedPoint point) {
    for (std::size_t number = points_.size() + 1; point.id.empty(); ++number) {
        const std::string id = fmt::format("point {}", number);
        const bool used = std::ranges::any_of(points_, [&](const ListedPoint& one) { return one.id == id; });
        if (!used) point.id = id;
    }
    auto points = points_;
    points.push_back(std::move(point));
    show(points);
    Q_EMIT edited(points_, tr("points"));
}

void PointListForm::endPicking() { pick_->setChecked(false); }

bool PointListForm::picking() const { return pick_->isChecked() && isVisible(); }

}  // namespace noonmark
