#include "app/window/widgets/accuracy_form.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QSignalBlocker>
#include <cmath>

#include "app/window/widgets/number_fields.h"

namespace noonmark {

namespace {

QString text(std::string_view view) { return QString::fromUtf8(view.data(), qsizetype(view.size())); }

bool isSwitch(const EngineOption& option) {
    return option.whole && option.unit.empty() && option.lowest == 0 && option.highest == 1;
}

QString switchWords(bool on) { return on ? QObject::tr("yes") : QObject::tr("no"); }

// Replaces the values 1 and 0 in an option's description by yes and no.
QString switchTipOf(const EngineOption& option) {
    QString about = text(option.about);
    for (const bool on : {true, false})
        about.replace(QStringLiteral("%1:").arg(int(on)), QStringLiteral("%1:").arg(switchWords(on)));
    return QObject::tr("%1.\nDefault: %2").arg(about, switchWords(option.usual != 0));
}

QString tipOf(const EngineOption& option) {
    if (isSwitch(option)) return switchTipOf(option);
    return QObject::tr("%1.\n%2 to %3 %4, default %5")
        .arg(text(option.about))
        .arg(option.lowest)
        .arg(option.highest)
        .arg(text(option.unit))
        .arg(option.usual);
}

// As many decimals as the option's own values have.
int decimalsOf(const EngineOption& option) {
    if (option.whole) return 0;
    for (int decimals = 2; decimals < 9; ++decimals) {
        const double grains = std::pow(10, decimals);
        const auto shows = [grains](double value) {
            return std::abs(std::round(value * grains) - value * grains) < 1e-6;
        };
        if (shows(option.usual) && shows(option.lowest)) return decimals;
    }
    return 9;
}

/// A number field that shows yes for 1 and no for 0.
class SwitchField final : public QDoubleSpinBox {
public:
    SwitchField() {
        setDecimals(0);
        setRange(0, 1);
        setWrapping(true);
        lineEdit()->setReadOnly(true);
    }
    [[nodiscard]] QString textFromValue(double value) const override { return switchWords(value != 0); }
    [[nodiscard]] double valueFromText(const QString& text) const override {
        return text == textFromValue(1) ? 1 : 0;
    }
    QValidator::State validate(QString&, int&) const override { return QValidator::Acceptable; }
};

QDoubleSpinBox* numberFieldOf(const EngineOption& option) {
    const QString unit = option.unit.empty() ? QString() : QLatin1Char(' ') + text(option.unit);
    // A default of 0 that is also the minimum means that the engine chooses.
    const bool byItself = option.usual == 0 && option.lowest == 0;
    const double step = option.whole ? 1 : byItself ? option.highest / 20 : option.usual / 10;
    QDoubleSpinBox* box = numberField(option.lowest, option.highest, decimalsOf(option), step, unit);
    if (byItself) box->setSpecialValueText(QObject::tr("automatic"));
    return box;
}

QDoubleSpinBox* fieldOf(const EngineOption& option) {
    QDoubleSpinBox* box = isSwitch(option) ? new SwitchField : numberFieldOf(option);
    box->setObjectName(QStringLiteral("option_") + text(option.key));
    box->setToolTip(tipOf(option));
    box->setValue(option.usual);
    return box;
}

}  // namespace

AccuracyForm::AccuracyForm(const EngineList& engines, QWidget* parent)
    : QWidget(parent),
      engines_(engines),
      cell_(numberField(ReceiverSettings::minCellM, ReceiverSettings::maxCellM, 2, 0.25, tr(" m"))),
      engine_(new QComboBox),
      form_(new QFormLayout(this)) {
    cell_->setObjectName(QStringLiteral("cell"));
    cell_->setToolTip(tr("Side of a ground cell, metres, 0.25 to 10"));
    fillEngines();
    form_->setContentsMargins(0, 0, 0, 0);
    form_->addRow(tr("Cell size"), cell_);
    form_->addRow(tr("Engine"), engine_);
    fixedRows_ = form_->rowCount();
    connect(cell_, &QDoubleSpinBox::valueChanged, this, [this] { Q_EMIT edited(tr("cell size")); });
    connect(engine_, &QComboBox::currentIndexChanged, this, [this] {
        chooseEngine();
        Q_EMIT edited(tr("engine"));
    });
    chooseEngine();
}

void AccuracyForm::fillEngines() {
    engine_->setObjectName(QStringLiteral("engine"));
    engine_->setToolTip(
        tr("How the shadow is computed; the ray reference is the standard for the errors of the others"));
    // A long engine name must not widen the dock.
    engine_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    engine_->setMinimumContentsLength(18);
    for (const auto& [engine, make] : engines_) {
        engine_->addItem(text(engine.name), text(engine.key));
        engine_->setItemData(engine_->count() - 1, text(engine.about), Qt::ToolTipRole);
    }
}

void AccuracyForm::chooseEngine() {
    const std::string key = engine_->currentData().toString().toStdString();
    const EngineEntry* engine = findEngine(engines_, key);
    if (engine && key != shown_) makeFields(engine->info);
}

void AccuracyForm::makeFields(const EngineInfo& engine) {
    while (form_->rowCount() > fixedRows_) form_->removeRow(fixedRows_);
    fields_.clear();
    shown_ = std::string(engine.key);
    for (const EngineOption& option : engine.options) {
        fields_.push_back({option, fieldOf(option)});
        form_->addRow(text(option.name), fields_.back().box);
        connect(fields_.back().box, &QDoubleSpinBox::valueChanged, this,
                [this, name = text(option.name)] { Q_EMIT edited(name); });
    }
}

void AccuracyForm::show(const StudySettings& settings) {
    const QSignalBlocker quiet(this);
    cell_->setValue(settings.receivers.cellM);
    engine_->setCurrentIndex(engine_->findData(QString::fromStdString(settings.engine)));
    for (const Field& field : fields_) {
        const auto set = settings.engineSettings.find(field.option.key);
        field.box->setValue(set == settings.engineSettings.end() ? field.option.usual : set->second);
    }
}

StudySettings AccuracyForm::applied(StudySettings settings) const {
    settings.receivers.cellM = cell_->value();
    settings.engine = shown_;
    settings.engineSettings.clear();
    for (const Field& field : fields_) {
        const double halfGrain = 0.5 * std::pow(10, -field.box->decimals());
        if (std::abs(field.box->value() - field.option.usual) >= halfGrain)
            settings.engineSettings.emplace(field.option.key, field.box->value());
    }
    return settings;
}

}  // namespace noonmark
