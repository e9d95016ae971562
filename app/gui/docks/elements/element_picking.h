#pragma once

#include <QObject>
#include <QPointF>
#include <vector>

namespace noonmark {

class ElementForm;
class ViewPanel;
class Workbench;

/// Clicks on the view choose faces or points for the form that asks for them. One form asks at a time.
class ElementPicking final : public QObject {
    Q_OBJECT
public:
    ElementPicking(Workbench& workbench, ViewPanel& panel);  ///< both must outlive this object

    void serve(ElementForm& form);  ///< it must outlive this object

private:
    void begin(const ElementForm& form, bool faces);
    void click(QPointF pixel);

    Workbench& workbench_;
    ViewPanel& panel_;
    std::vector<ElementForm*> forms_;
};

}  // namespace noonmark
