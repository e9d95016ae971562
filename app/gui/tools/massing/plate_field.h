#pragma once

#include <QWidget>

#include "scenarios/massing/massing.h"

class QComboBox;
class QDoubleSpinBox;

namespace noonmark {

/// The size of a floor plate: the whole lot, a share of it, or an area in the units in use.
class PlateField final : public QWidget {
    Q_OBJECT
public:
    explicit PlateField(QWidget* parent = nullptr);

    [[nodiscard]] PlateSize plate() const;
    void show(const PlateSize& plate);  ///< without a signal
    [[nodiscard]] QDoubleSpinBox* sizeField() const { return size_; }

Q_SIGNALS:
    void edited();

private:
    void choose(int kind);
    void chooseArea();
    [[nodiscard]] double typedM2() const;

    QComboBox* kind_;
    QDoubleSpinBox* size_;
    std::optional<double> areaM2_;  ///< as it was shown last
};

}  // namespace noonmark
