// SPDX-License-Identifier: MIT
#include "flatland/io/limits_text.h"

#include "flatland/io/number_text.h"

namespace flatland {

namespace {

std::string quoted(std::string_view text) { return '"' + std::string(text) + '"'; }

std::string lawText(const LimitLaw& law) {
  std::string text = "{\"quantity\": " + quoted(nameOf(law.quantity)) +
                     ", \"predictedOrder\": " + numberText(law.order, "null") +
                     ", \"predictedCoefficient\": " + numberText(law.coefficient, "null");
  if (law.fit) {
    text += ", \"fittedOrder\": " + numberText(law.fit->slope) +
            ", \"standardError\": " + numberText(law.fit->slopeError) +
            ", \"fittedCoefficient\": " + numberText(law.fit->coefficient) + ", \"fittedOver\": [" +
            numberText(law.fit->xLow) + ", " + numberText(law.fit->xHigh) + "]";
  } else {
    text += ", \"fittedOrder\": null";
  }
  text += ", \"values\": [";
  for (std::size_t i = 0; i < law.values.size(); ++i) {
    text += (i == 0 ? "" : ", ") + numberText(std::optional(law.values[i]), "null");
  }
  return text + "]}";
}

}  // namespace

std::string limitsToJson(const std::vector<LimitSeries>& series) {
  std::string text = "{\n  \"flatland\": 1,\n  \"study\": \"limits\",\n  \"experiments\": [";
  bool first = true;
  for (const LimitSeries& each : series) {
    text += first ? "\n    {" : ",\n    {";
    first = false;
    text += "\"experiment\": " + quoted(nameOf(each.experiment)) +
            ", \"case\": " + quoted(nameOf(each.limitCase)) +
            ", \"curve\": " + std::to_string(each.curve) + ", \"t\": " + numberText(each.t) +
            ", \"u\": " + numberText(each.u) + ", \"angleDeg\": " + numberText(each.angleDeg) +
            ",\n     \"x\": [";
    for (std::size_t i = 0; i < each.x.size(); ++i) {
      text += (i == 0 ? "" : ", ") + numberText(each.x[i]);
    }
    text += "],\n     \"laws\": [";
    for (std::size_t i = 0; i < each.laws.size(); ++i) {
      text += (i == 0 ? "\n       " : ",\n       ") + lawText(each.laws[i]);
    }
    text += "]}";
  }
  return text + (first ? "]\n}\n" : "\n  ]\n}\n");
}

std::string limitsToCsv(const std::vector<LimitSeries>& series) {
  std::string text = "experiment,case,quantity,x,value\r\n";
  for (const LimitSeries& each : series) {
    for (const LimitLaw& law : each.laws) {
      for (std::size_t i = 0; i < each.x.size(); ++i) {
        text += std::string(nameOf(each.experiment)) + ',' + std::string(nameOf(each.limitCase)) +
                ',' + std::string(nameOf(law.quantity)) + ',' + numberText(each.x[i]) + ',' +
                numberText(std::optional(law.values[i]), "") + "\r\n";
      }
    }
  }
  return text;
}

}  // namespace flatland
