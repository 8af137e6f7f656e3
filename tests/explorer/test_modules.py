"""Joining of JavaScript modules."""

import pytest

from explorer.modules import ModuleError, join


def write(folder, **modules):
    for name, text in modules.items():
        (folder / f"{name}.js").write_text(text)
    return folder / "main.js"


def test_modules_come_after_what_they_import_without_comments(tmp_path):
    main = write(
        tmp_path,
        main='// The page.\nimport { one } from "./a.js";\n'
        'import {\n  two,\n} from "./b.js";\n\none(two);\n',
        a='import { two } from "./b.js";\n\n/** One.\n *\n * more\n */\n'
        "export function one() {\n  // two\n  return two; // kept\n}\n",
        b="export const two = 2;\n",
    )
    assert join(main) == (
        "// b.js\nconst two = 2;\n\n"
        "// a.js\nfunction one() {\n  return two; // kept\n}\n\n"
        "// main.js\none(two);\n"
    )


@pytest.mark.parametrize(
    ("modules", "message"),
    [
        ({"a": "const one = 1;\n"}, r"main.js: \./a.js does not export one"),
        (
            {"a": 'import { x } from "./main.js";\nexport const one = x;\n'},
            "main.js: imports itself",
        ),
        (
            {"a": "export const one = 1;\nconst same = 1;\n"},
            "main.js: same is a top-level name of a",
        ),
        ({"a": "export const one = 1;\nexport { one as two };\n"}, "a.js: expected another form"),
        ({"a": 'import x from "./b.js";\nexport const one = x;\n'}, "a.js: expected another form"),
    ],
)
def test_what_cannot_be_joined_is_named(tmp_path, modules, message):
    main = write(tmp_path, main='import { one } from "./a.js";\nconst same = one;\n', **modules)
    with pytest.raises(ModuleError, match=message):
        join(main)


def test_an_import_without_use_is_named(tmp_path):
    main = write(tmp_path, main='import { one } from "./a.js";\n', a="export const one = 1;\n")
    with pytest.raises(ModuleError, match=r"main\.js: imports one without use"):
        join(main)
