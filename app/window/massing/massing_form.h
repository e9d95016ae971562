#pragma once

#include <QWidget>

#include "scenarios/massing/massing.h"

class QDoubleSpinBox;
class QGroupBox;
class QSpinBox;

namespace noonmark {

class PlateField;
class SetbackTable;

/// Fields for the MassingSettings of one tower. Number of storeys and total height are two fields for one
/// quantity: changing one updates the other.
class MassingForm final : public QWidget {
    Q_OBJECT
public:
    explicit MassingForm(QWidget* parent = nullptr);

    [[nodiscard]] const MassingSettings& settings() const { return settings_; }
    void show(const MassingSettings& settings);  ///< without a signal

Q_SIGNALS:
    void edited();

private:
    void makeFields();
    void connectFields();
    void takeHeight();
    void takeRest();
    void addSetback();

    MassingSettings settings_;
    QSpinBox* storeys_;
    QDoubleSpinBox* storeyHeight_;
    QDoubleSpinBox* height_;
    PlateField* plate_;
    QDoubleSpinBox* turn_;
    QGroupBox* podium_;
    QSpinBox* podiumStoreys_;
    PlateField* podiumPlate_;
    SetbackTable* setbacks_;
    bool showing_ = false;
};

}  // namespace noonmark
