// SPDX-License-Identifier: GPL-3.0-or-later
// detent._core: the library for Python. Its functions are described in detent/__init__.py; types in
// detent/_core.pyi.
//
// Reading order: refusal.h (failures become exceptions), interruptible.h (work that Ctrl-C ends), reading.h,
// forecasts.h, this file. Paths and other text that may be any bytes come as bytes. Curves are views on
// memory of their own: nothing is copied on the way.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "editor/python/core/forecasts.h"
#include "editor/python/core/interruptible.h"
#include "editor/python/core/reading.h"
#include "editor/python/core/refusal.h"
#include "model/compare.h"
#include "model/edits.h"
#include "model/file/button_file.h"
#include "model/file/graph_program.h"
#include "model/key_figures.h"
#include "model/sampling.h"
#include "model/version.h"

namespace py = pybind11;

namespace detent::python {
namespace {

/// A button and the picture its file carries.
struct KeptButton {
  Button button;
  std::optional<PageCutout> cutout = {};

  const ButtonState& state(std::size_t index) const {
    if (index >= button.states().size()) throw py::index_error("the button has no such state");
    return button.states()[index];
  }
  bool operator==(const KeptButton& other) const { return toJson() == other.toJson(); }
  std::string toJson() const { return jsonFrom(button, cutout); }
};

/// A read-only array of n rows over memory that `owner` keeps.
template <class Number, class Owner>
py::array_t<Number> viewOf(std::unique_ptr<Owner> owner, std::vector<py::ssize_t> shape) {
  const Number* const first = reinterpret_cast<const Number*>(owner->data());
  const py::capsule keeper(owner.release(), [](void* kept) { delete static_cast<Owner*>(kept); });
  py::array_t<Number> view(std::move(shape), first, keeper);
  view.attr("setflags")(py::arg("write") = false);
  return view;
}

static_assert(sizeof(CurvePoint) == 2 * sizeof(double) && sizeof(DampingPoint) == 2 * sizeof(double));

template <class Point>
py::array_t<double> columnsOf(std::vector<Point> points) {
  const auto rows = static_cast<py::ssize_t>(points.size());
  return viewOf<double>(std::make_unique<std::vector<Point>>(std::move(points)), {rows, 2});
}

/// Runs work that Ctrl-C can end, and returns its value; a Refusal becomes an exception.
template <class T, class Work>
T answered(Work work) {
  return interruptible<Answer<T>>([work = std::move(work)](const Cancelled& cancelled) {
           return answerOf<T>([&] { return work(cancelled); });
         })
      .take();
}

// ---- buttons

KeptButton loaded(const std::string& path) {
  if (valueOf(kindOfFile(path)) == GraphFileKind::button) {
    ButtonFile file = valueOf(readWholeButtonFile(path));
    return {std::move(file.button), std::move(file.cutout)};
  }
  return {valueOf(readButton(path))};
}

KeptButton fromJson(const std::string& text, const std::string& name) {
  ButtonFile file = valueOf(buttonFileFromJson(text, name));
  return {std::move(file.button), std::move(file.cutout)};
}

Stroke strokeOf(bool press) { return press ? Stroke::press : Stroke::release; }

std::optional<py::array_t<double>> pointsOf(const KeptButton& kept, std::size_t state, bool press) {
  const ForceGraph& graph = kept.state(state).graph;
  if (!press && !graph.release()) return {};
  return columnsOf(travelledSamples(graph, strokeOf(press)));
}

py::dict figuresOf(const KeptButton& kept, std::size_t state) {
  const KeyFigures figures = keyFiguresOf(kept.state(state));
  py::dict all;
  for (const KeyFigureName& name : keyFigureNames())
    if (const auto& value = figures[name.figure]) all[py::str(std::string(name.key))] = *value;
  return all;
}

// ---- edits

KeptButton edited(const KeptButton& kept, Result<Button> result) {
  return {valueOf(std::move(result)), kept.cutout};
}

KeptButton withStroke(const KeptButton& kept, std::size_t state, bool press, const CurveEdit& edit) {
  kept.state(state);
  return edited(kept, editGraph(kept.button, state, [&](const ForceGraph& graph) {
                  return editStroke(graph, strokeOf(press), edit);
                }));
}

KeptButton withGraph(const KeptButton& kept, std::size_t state, const GraphEdit& edit) {
  kept.state(state);
  return edited(kept, editGraph(kept.button, state, edit));
}

void bindEdits(py::class_<KeptButton>& button) {
  button
      .def("rename",
           [](const KeptButton& b, const std::string& name) { return edited(b, rename(b.button, name)); })
      .def("scale_force",
           [](const KeptButton& b, double factor) { return edited(b, scaleForce(b.button, factor)); })
      .def("scale_travel",
           [](const KeptButton& b, double factor) { return edited(b, scaleTravel(b.button, factor)); })
      .def("scale_snap",
           [](const KeptButton& b, double factor) { return edited(b, scaleSnapRatios(b.button, factor)); })
      .def("operate_at",
           [](const KeptButton& b, std::optional<double> at_mm, std::size_t state) {
             b.state(state);
             return edited(b, setOperatingPoint(b.button, state, at_mm));
           })
      .def("reset_at",
           [](const KeptButton& b, std::optional<double> at_mm, std::size_t state) {
             b.state(state);
             return edited(b, setResetPoint(b.button, state, at_mm));
           })
      .def("mirror_release",
           [](const KeptButton& b, double hysteresis_N, std::size_t state) {
             return withGraph(b, state,
                              [&](const ForceGraph& g) { return mirrorPressToRelease(g, hysteresis_N); });
           })
      .def("remove_release",
           [](const KeptButton& b, std::size_t state) {
             return withGraph(b, state, [](const ForceGraph& g) { return removeRelease(g); });
           })
      .def("move_tactile_point",
           [](const KeptButton& b, std::size_t index, double to_mm, double to_N, bool press,
              std::size_t state) {
             return withStroke(b, state, press, [&](const StrokeCurve& curve) {
               return moveTactilePoint(curve, strokeOf(press), index, {to_mm, to_N});
             });
           })
      .def("add_jump",
           [](const KeptButton& b, double at_mm, double width_mm, double drop_N, bool press,
              std::size_t state) {
             return withStroke(b, state, press, [&](const StrokeCurve& curve) {
               return addJump(curve, strokeOf(press), {at_mm, width_mm, drop_N});
             });
           })
      .def("remove_jump",
           [](const KeptButton& b, std::size_t index, bool press, std::size_t state) {
             return withStroke(b, state, press, [&](const StrokeCurve& curve) {
               return removeJump(curve, strokeOf(press), index);
             });
           })
      .def("make_linear", [](const KeptButton& b, bool press, std::size_t state) {
        return withStroke(b, state, press, [](const StrokeCurve& curve) { return makeLinear(curve); });
      });
}

void bindButton(py::module_& core) {
  py::class_<KeptButton> button(core, "Button");
  button.def_static("load", &loaded)
      .def_static("from_json", &fromJson)
      .def("to_json", &KeptButton::toJson)
      .def("svg", [](const KeptButton& b) { return svgFrom(b.button); })
      .def_property_readonly("name", [](const KeptButton& b) { return b.button.name(); })
      .def("__len__", [](const KeptButton& b) { return b.button.states().size(); })
      .def("state_name", [](const KeptButton& b, std::size_t state) { return b.state(state).name; })
      .def("operating_point_mm",
           [](const KeptButton& b, std::size_t state) { return b.state(state).operatingPoint_mm; })
      .def("reset_point_mm",
           [](const KeptButton& b, std::size_t state) { return b.state(state).resetPoint_mm; })
      .def("points", &pointsOf)
      .def("damping",
           [](const KeptButton& b, std::size_t state) { return columnsOf(b.state(state).damping); })
      .def("figures", &figuresOf)
      .def(
          "__eq__", [](const KeptButton& a, const KeptButton& b) { return a == b; }, py::is_operator());
  bindEdits(button);
}

// ---- reading

using Read = std::pair<KeptButton, std::string>;

Read given(ReadButton read) { return {KeptButton{std::move(read.button)}, std::move(read.reportJson)}; }

Read readOne(const std::string& path, const std::vector<std::string>& options) {
  return given(answered<ReadButton>([request = requestOf(options), path](const Cancelled& cancelled) {
    return readGraph(request, path, cancelled);
  }));
}

void bindReading(py::module_& core) {
  core.def("read", &readOne);
  py::class_<ReadMany>(core, "ReadMany")
      .def(py::init(
          [](const std::vector<std::string>& paths, const std::vector<std::string>& options,
             std::size_t jobs) { return std::make_unique<ReadMany>(paths, requestOf(options), jobs); }))
      .def("next", [](ReadMany& many) { return given(many.next().take()); })
      .def("stop", &ReadMany::stop);
}

// ---- values computed from buttons

std::vector<Button> plain(const std::vector<KeptButton>& kept) {
  std::vector<Button> buttons;
  for (const KeptButton& each : kept) buttons.push_back(each.button);
  return buttons;
}

py::array_t<float> rendered(const KeptButton& kept, const std::string& traceFile, double rate_Hz,
                            const std::string& feel) {
  auto samples = answered<std::vector<float>>(
      [button = kept.button, traceFile, rate_Hz, feel](const Cancelled& cancelled) {
        return renderedPress(button, traceFile, rate_Hz, feel, cancelled);
      });
  const auto count = static_cast<py::ssize_t>(samples.size());
  return viewOf<float>(std::make_unique<std::vector<float>>(std::move(samples)), {count});
}

Read averaged(const std::vector<KeptButton>& units) {
  UnitSpread spread = valueOf(spreadOf(plain(units)));
  std::string json = averageReport(spread, std::vector<std::string>(units.size()), "").json;
  return {KeptButton{std::move(spread.mean)}, std::move(json)};
}

Read between(const KeptButton& from, const KeptButton& to, std::optional<double> share) {
  auto [button, json] = answered<std::pair<Button, std::string>>(
      [from = from.button, to = to.button, share](const Cancelled& cancelled) {
        return buttonBetween(from, to, share, cancelled);
      });
  return {KeptButton{std::move(button)}, std::move(json)};
}

void bindAnswers(py::module_& core) {
  core.def("render", &rendered);
  core.def("average", &averaged);
  core.def("between", &between);
  core.def("confusion", [](const std::vector<KeptButton>& buttons) {
    return answered<std::string>(
        [all = plain(buttons)](const Cancelled& cancelled) { return confusionOf(all, cancelled); });
  });
  core.def("performance", [](const std::vector<KeptButton>& buttons, std::optional<double> operateAt_mm) {
    return answered<std::string>([all = plain(buttons), operateAt_mm](const Cancelled& cancelled) {
      return performanceOf(all, operateAt_mm, cancelled);
    });
  });
  core.def("find_like", [](const KeptButton& button, const std::string& database, std::size_t limit) {
    return answered<std::string>([like = button.button, database, limit](const Cancelled&) {
      return switchesLike(like, database, limit);
    });
  });
  core.def("compare", [](const KeptButton& a, const KeptButton& b, std::size_t stateA, std::size_t stateB) {
    return compareReport(
               valueOf(compare(polylinesOf(a.state(stateA).graph), polylinesOf(b.state(stateB).graph))), "",
               "")
        .json;
  });
}

/// A Python string. Bytes of a file name that are not valid UTF-8 are converted as os.fsdecode does.
py::str textOf(const std::string& bytes) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<py::ssize_t>(bytes.size()), "surrogateescape"));
}

void raise(std::exception_ptr thrown) {
  try {
    std::rethrow_exception(std::move(thrown));
  } catch (const Refusal& refusal) {
    const Refused& why = refusal.why();
    py::list remedies;
    for (const std::string& remedy : why.remedies) remedies.append(textOf(remedy));
    const py::object failure =
        py::module_::import("detent.failure")
            .attr("failure_of")(why.code, textOf(why.sentence), remedies, textOf(why.reportJson));
    PyErr_SetObject(py::type::handle_of(failure).ptr(), failure.ptr());
  }
}

}  // namespace
}  // namespace detent::python

PYBIND11_MODULE(_core, core) {
  using namespace detent::python;
  core.attr("version") = detent::version();
  py::register_exception_translator(&raise);
  bindButton(core);
  bindReading(core);
  bindAnswers(core);
}
