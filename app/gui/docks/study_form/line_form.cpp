#include "app/gui/docks/study_form/line_form.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSignalBlocker>

#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/length_field.h"
#include "core/base/length_text.h"

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

}  // namespace noonmark
