#!/usr/bin/env python3
"""Answers of a rehearsal, and the truths that are open, as committed here.

answers.py pack FOLDER      writes answers.json and truths.json from the folder that `demens gap rehearse` works in: of each case that has an answer
answers.py unpack FOLDER    makes such a folder of them and seals.json, for `demens gap rehearse score FOLDER`
"""
import json
import pathlib
import sys

here = pathlib.Path(__file__).parent


def rounded(value):
    """All that a score asks for, to five digits."""
    if isinstance(value, float):
        return float(f"{value:.5g}")
    if isinstance(value, list):
        return [rounded(one) for one in value]
    return {key: rounded(one) for key, one in value.items()} if isinstance(value, dict) else value


def kept(answer):
    if "which" not in answer:
        return answer
    answer["where"]["cells"] = [{key: cell[key] for key in ("cell", "finding", "sigmas")} for cell in answer["where"]["cells"]]
    for effect in answer["which"]["effects"]:
        del effect["amplitude_meaning"]
    for effect in (answer["how_far"] or {"effects": []})["effects"]:
        del effect["cells"]
    return {key: answer[key] for key in ("which", "where", "how_far", "simpler_rules", "assumed") if key in answer}


def write_lines(name, cases):
    """A JSON object with a line a case."""
    lines = [f'"{case}": {json.dumps(value, separators=(",", ":"))}' for case, value in sorted(cases.items())]
    (here / name).write_text("{\n" + ",\n".join(lines) + "\n}\n")


def pack(folder):
    answers, truths = {}, {}
    for path in sorted(folder.glob("cases/*/answer.json")):
        case = path.parent.name
        answers[case] = rounded(kept(json.loads(path.read_text())))
        truths[case] = json.loads((folder / "truth" / f"{case}.json").read_text())
    write_lines("answers.json", answers)
    write_lines("truths.json", truths)


def unpack(folder):
    (folder / "truth").mkdir(parents=True)
    (folder / "seals.json").write_text((here / "seals.json").read_text())
    truths = json.loads((here / "truths.json").read_text())
    for case, answer in json.loads((here / "answers.json").read_text()).items():
        to = folder / "cases" / case
        to.mkdir(parents=True)
        (to / "campaign.toml").write_text("# see make_campaign.py\n")
        (to / "answer.json").write_text(json.dumps(answer))
        (folder / "truth" / f"{case}.json").write_text(json.dumps(truths[case]))


{"pack": pack, "unpack": unpack}[sys.argv[1]](pathlib.Path(sys.argv[2]))
