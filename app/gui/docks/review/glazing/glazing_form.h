#pragma once

#include <QWidget>

#include "core/study/elements/place_elements.h"

class QComboBox;

namespace noonmark {

class ElementForm;

/// Which windows a rule is evaluated on: one in each bay and storey of facades, or those of a file.
class GlazingForm final : public QWidget {
    Q_OBJECT
public:
    explicit GlazingForm(QWidget* parent = nullptr);

    void show(const ElementSettings& windows);  ///< without a signal
    void setBuilding(const QString& id);        ///< the selected building; empty: none
    [[nodiscard]] ElementForm& elements() { return *form_; }

Q_SIGNALS:
    void edited(noonmark::ElementSettings windows);

private:
    QComboBox* source_;
    ElementForm* form_;
};

}  // namespace noonmark
