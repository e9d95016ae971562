#pragma once

#include <QFrame>

#include "core/measures/colour_scale.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace noonmark {

/// A small window beside the legend in which it is changed: what is shown, colours, range, classes. Each
/// change shows at once; the window stays open beside the others.
class LegendEditor final : public QFrame {
    Q_OBJECT
public:
    explicit LegendEditor(QWidget* parent);

    /// The choice to be edited. `fitted`: the scale of the map on display, whose range a click locks; none:
    /// the map is one of differences or of a moment, whose colours are their own.
    void setChoice(const LegendChoice& choice, const std::optional<ColourScale>& fitted);
    /// Whether the map of places shows the hours that range and numbers are of; before setChoice().
    void setHoursShown(bool shown) { hoursShown_ = shown; }
    void setCanUndo(bool can);

    /// Whether a scale is of hours of sun by place, which has no other measure.
    [[nodiscard]] static bool isOfPlaces(const ColourScale& scale) {
        return scale.quantity.isSun() && scale.quantity.sunlitMin == 0;
    }

Q_SIGNALS:
    void chosen(const LegendChoice& choice);
    void undoRequested();
    void closed();  ///< by the user: the keyboard is free

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void addRows();
    void connectRows();
    void take();
    [[nodiscard]] std::optional<LegendChoice> readRows() const;
    [[nodiscard]] bool aroundZero() const { return fitted_ && fitted_->of != ColourScale::Of::minutes; }
    [[nodiscard]] bool isOfPlaces() const;
    [[nodiscard]] static LegendChoice withHours(LegendChoice choice, const LegendClasses& classes,
                                                const std::optional<LegendRange>& range);
    [[nodiscard]] std::vector<Choice<Ramp>> listRamps() const;
    void fillRamps();
    [[nodiscard]] std::optional<LegendClasses> readClasses() const;
    void showEnabled();

    LegendChoice choice_;
    bool hoursShown_ = true;
    std::optional<ColourScale> fitted_;
    QComboBox* show_;
    QComboBox* ramp_;
    QCheckBox* reversed_;
    QCheckBox* locked_;
    QLineEdit* range_;
    QComboBox* kind_;
    QSpinBox* count_;
    QLineEdit* breaks_;
    QLabel* problem_;
    QPushButton* undo_;
};

}  // namespace noonmark
