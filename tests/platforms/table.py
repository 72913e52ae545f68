"""The matrix as Markdown."""

HEAD = ("platform", "built by", "flags", "run by", "state hashes")


def line(cells, widths):
    """One line of the table."""
    return "| " + " | ".join(f"{cell:<{width}}" for cell, width in zip(cells, widths, strict=True)) + " |"


def to_markdown(results):
    """All results, one a line."""
    rows = [(result.name, result.built_by, f"`{result.flags}`" if result.flags else "", result.runs_on, result.verdict)
            for result in results]
    widths = [max(len(row[column]) for row in (HEAD, *rows)) for column in range(len(HEAD))]
    rule = "|" + "|".join("-" * (width + 2) for width in widths) + "|"
    return "\n".join([line(HEAD, widths), rule, *(line(row, widths) for row in rows)]) + "\n"
